// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/io/io_pages.h"

#include <QHBoxLayout>
#include <QStackedWidget>
#include <QVBoxLayout>

#include "widgets/common/segmented_control.h"
#include "widgets/io/gripper_panel.h"
#include "widgets/io/io_tab.h"

namespace tiller {

IoPages::IoPages(IoTab* signalsPage, GripperPanel* gripperPage, QWidget* parent)
    : QWidget(parent)
    , choice_(new SegmentedControl({tr("Signals"), tr("Gripper")}))
    , pages_(new QStackedWidget(this)) {
    setObjectName(QStringLiteral("ioPages"));
    choice_->setNames(QStringLiteral("io.part"), tr("I/O page"));
    pages_->addWidget(signalsPage);
    pages_->addWidget(gripperPage);
    auto* top = new QHBoxLayout;
    top->setContentsMargins(12, 8, 12, 0);
    top->addWidget(choice_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addLayout(top);
    layout->addWidget(pages_, 1);
    connect(choice_, &SegmentedControl::currentChanged, this, [this](int index) {
        pages_->setCurrentIndex(index);
        Q_EMIT pageChanged();
    });
}

IoPages::Page IoPages::page() const {
    return pages_->currentIndex() == 0 ? Page::Signals : Page::Gripper;
}

void IoPages::show(Page page) {
    choice_->setCurrentIndex(page == Page::Signals ? 0 : 1);
}

}  // namespace tiller

#include "moc_io_pages.cpp"
