// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/tools/tools_tab.h"

#include <QStackedWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "robot/station/document/project_document.h"
#include "widgets/common/no_focus_scroll_area.h"
#include "widgets/common/segmented_control.h"
#include "widgets/tools/cell_page.h"
#include "widgets/tools/payload_page.h"
#include "widgets/tools/positions_page.h"
#include "widgets/tools/tcp_page.h"

namespace tiller {

namespace {

/// A page that scrolls vertically if the tab is too short. It is never narrower than its buttons.
class PageArea : public NoFocusScrollArea {
public:
    explicit PageArea(QWidget* page) {
        setWidgetResizable(true);
        setFrameShape(QFrame::NoFrame);
        setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
        setWidget(page);
        setAccessibleName(page->accessibleName());
        page->setAutoFillBackground(false);
        viewport()->setAutoFillBackground(false);
    }
    QSize minimumSizeHint() const override {
        constexpr int kLowest = 160;  // [px]
        const QSize page = widget()->minimumSizeHint();
        return {page.width(), std::min(page.height(), kLowest)};
    }
};

}  // namespace

ToolsTab::ToolsTab(RobotSession& session, ProjectDocument& document, HoldPolicy& policy, QWidget* parent)
    : ToolsTab(session, document, motionPort(session), policy, parent) {}

ToolsTab::ToolsTab(RobotSession& session, ProjectDocument& document, MotionPort port, HoldPolicy& policy,
                   QWidget* parent)
    : QWidget(parent)
    , state_(session.state())
    , choice_(new SegmentedControl({tr("TCP"), tr("Payload"), tr("Positions"), tr("Cell")}))
    , pages_(new QStackedWidget)
    , tcps_(new TcpPage(session, document))
    , payloads_(new PayloadPage(session, document, std::move(port), policy))
    , positions_(new PositionsPage(session, document))
    , cell_(new CellPage(session, document)) {
    setObjectName(QStringLiteral("tools"));
    setAccessibleName(tr("Tools"));
    choice_->setNames(QStringLiteral("tools.page"), tr("TCP, payload, positions or cell"));
    for (QWidget* page : {static_cast<QWidget*>(tcps_), static_cast<QWidget*>(payloads_),
                          static_cast<QWidget*>(positions_), static_cast<QWidget*>(cell_)}) {
        pages_->addWidget(new PageArea(page));
    }
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 12, 0, 0);
    layout->setSpacing(0);
    auto* row = new QHBoxLayout;
    row->setContentsMargins(12, 0, 12, 0);
    row->addWidget(choice_);
    row->addStretch();
    layout->addLayout(row);
    layout->addWidget(pages_, 1);

    connect(choice_, &SegmentedControl::currentChanged, this, [this](int index) {
        Q_EMIT pageChanged();
        pages_->setCurrentIndex(index);
    });
    const auto connectPage = [this](PartPage* page, Page index) {
        connect(page, &PartPage::frontWanted, this, [this, index] {
            Q_EMIT frontWanted();
            showPage(index);
        });
    };
    connectPage(tcps_, Tcps);
    connectPage(payloads_, Payloads);
    connectPage(positions_, Positions);
    connectPage(cell_, Cell);
    connect(&document, &ProjectDocument::stepTaken, this, [this](const ProjectStep& step) {
        switch (step.part) {
            case ProjectPart::Tcps:
                showPage(Tcps);
                tcps_->followStep(step.id);
                break;
            case ProjectPart::Payloads:
                showPage(Payloads);
                payloads_->followStep(step.id);
                break;
            case ProjectPart::Positions:
                showPage(Positions);
                break;
            case ProjectPart::Cell:
                showPage(Cell);
                break;
            case ProjectPart::Waypoints:
            case ProjectPart::Frames:
            case ProjectPart::Programs:
                break;
        }
    });

    // Limit the update rate, because values that change 60 times per second are not legible. Measurements use
    // every state.
    liveTimer_.setSingleShot(true);
    liveTimer_.setInterval(100);
    connect(&liveTimer_, &QTimer::timeout, this, [this] {
        tcps_->setState(state_);
        positions_->setState(state_);
    });
    connect(&session, &RobotSession::stateChanged, this, [this](const SessionState& state) {
        state_ = state;
        payloads_->setState(state);
        cell_->setState(state);
        if (!liveTimer_.isActive()) {
            liveTimer_.start();
        }
    });
}

void ToolsTab::showPage(Page page) {
    choice_->setCurrentIndex(page);
}

QList<QAction*> ToolsTab::commandActions() const {
    return tcps_->commandActions() + payloads_->commandActions() + positions_->commandActions() +
           cell_->commandActions();
}

void ToolsTab::setHeldSpeed(std::function<HeldSpeed()> speed) {
    payloads_->setHeldSpeed(std::move(speed));
}

}  // namespace tiller

#include "moc_tools_tab.cpp"
