// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/tools/part_page.h"

#include <QAction>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QStackedWidget>
#include <QVBoxLayout>

#include "widgets/common/bottom_overlay.h"
#include "widgets/common/notice_bar.h"
#include "widgets/common/row_table.h"

namespace tiller {

PartPage::PartPage(const QString& name, const QString& title, PartModel* model, const QString& emptyText,
                   QWidget* details, QWidget* parent)
    : QWidget(parent)
    , name_(name)
    , model_(model)
    , usual_(new QWidget)
    , keys_(new QHBoxLayout)
    , more_(new QPushButton(QStringLiteral("···")))
    , menu_(new QMenu(this))
    , pages_(new QStackedWidget)
    , details_(details) {
    details_->setObjectName(name + QStringLiteral(".detailsArea"));
    setObjectName(name + QStringLiteral(".page"));
    setAccessibleName(title);
    model_->setParent(this);
    more_->setObjectName(name + QStringLiteral(".more"));
    more_->setAccessibleName(tr("More"));
    menu_->setObjectName(name + QStringLiteral(".menu"));
    more_->setMenu(menu_);
    keys_->setContentsMargins(12, 12, 12, 8);
    keys_->setSpacing(8);
    keys_->addWidget(more_);

    auto* empty = new QLabel(emptyText);
    empty->setObjectName(name + QStringLiteral(".empty"));
    empty->setProperty("role", "secondary");
    empty->setAlignment(Qt::AlignCenter);
    empty->setWordWrap(true);
    empty->setMargin(12);
    table_ = new RowTable(*model_, PartModel::Name);
    table_->setObjectName(name + QStringLiteral(".table"));
    table_->setAccessibleName(title);
    table_->setItemDelegate(new RowDelegate(name + QStringLiteral(".editor"), table_));
    table_->setSelectionMode(QAbstractItemView::SingleSelection);
    table_->setColumnWidth(PartModel::Mark, 30);
    pages_->addWidget(empty);
    pages_->addWidget(table_);

    auto* usualLayout = new QVBoxLayout(usual_);
    usualLayout->setContentsMargins(0, 0, 0, 0);
    usualLayout->setSpacing(0);
    usualLayout->addLayout(keys_);
    usualLayout->addWidget(pages_, 1);
    usualLayout->addWidget(details_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(usual_, 1);
    notice_ = new NoticeBar;
    new BottomOverlay(*notice_, *this, {pages_, usual_});

    connect(table_, &RowTable::currentRowChanged, this, [this] {
        for (QAction* action : actions_) {
            action->setEnabled(!action->property("needsRow").toBool() || currentRow() >= 0);
        }
        onSelection();
    });
    connect(model_, &PartModel::editRefused, this, &PartPage::showProblem);
    table_->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(table_, &QWidget::customContextMenuRequested, this,
            [this](const QPoint& position) { menu_->popup(table_->viewport()->mapToGlobal(position)); });
}

PartPage::~PartPage() {
    // The base class destroys the table after its model, and the document may already be destroyed.
    disconnect(table_, nullptr, this, nullptr);
}

int PartPage::currentRow() const {
    const QModelIndex current = table_->currentIndex();
    return current.isValid() && current.row() < model_->rowCount() ? current.row() : -1;
}

void PartPage::selectRow(int row) {
    if (row < 0 || row >= model_->rowCount()) {
        table_->selectionModel()->clear();
    } else {
        const QModelIndex index = model_->index(row, PartModel::Name);
        table_->selectionModel()->setCurrentIndex(
            index, QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
        table_->scrollTo(index);
    }
    onSelection();
}

QPushButton* PartPage::addKey(const QString& name, const QString& text, const QString& spoken, int stretch,
                              std::function<void()> run) {
    auto* key = new QPushButton(text);
    key->setObjectName(name_ + QLatin1Char('.') + name);
    key->setAccessibleName(spoken);
    connect(key, &QPushButton::clicked, this, [run = std::move(run)] { run(); });
    keys_->insertWidget(keys_->count() - 1, key, stretch);
    return key;
}

QAction* PartPage::addCommand(const QString& name, const QString& text, bool needsRow,
                              std::function<void()> run) {
    auto* action = new QAction(text, this);
    action->setObjectName(name_ + QStringLiteral(".action.") + name);
    action->setProperty("needsRow", needsRow);
    action->setEnabled(!needsRow || currentRow() >= 0);
    connect(action, &QAction::triggered, this, [this, run = std::move(run)] {
        Q_EMIT frontWanted();
        run();
    });
    actions_.append(action);
    menu_->addAction(action);
    return action;
}

void PartPage::showInstead(QWidget* widget) {
    if (instead_ != nullptr) {
        instead_->hide();
        layout()->removeWidget(instead_);
    }
    instead_ = widget;
    usual_->setVisible(widget == nullptr);
    if (widget != nullptr) {
        static_cast<QVBoxLayout*>(layout())->addWidget(widget, 1);
        widget->show();
    }
}

void PartPage::showProblem(const QString& text) {
    notice_->show(NoticeBar::Kind::Warning, text, {});
}

void PartPage::followList() {
    model_->follow();
    pages_->setCurrentIndex(model_->rowCount() == 0 ? 0 : 1);
    details_->setVisible(detailsAlways_ || model_->rowCount() > 0);
    if (currentRow() < 0 && model_->rowCount() > 0) {
        selectRow(model_->rowCount() - 1);
    } else {
        onSelection();
    }
}

}  // namespace tiller

#include "moc_part_page.cpp"
