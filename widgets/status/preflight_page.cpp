// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/status/preflight_page.h"

#include <QEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QStyle>
#include <QVBoxLayout>
#include <algorithm>

#include "robot/station/text/notation.h"
#include "widgets/common/no_focus_scroll_area.h"
#include "widgets/common/shapes.h"
#include "widgets/common/theme.h"

namespace tiller {
namespace {

constexpr std::chrono::seconds kAtMost{30};
constexpr int kTitle = 230;            // minimum width of the column [px]
constexpr double kFirstSpeed = 0.050;  // initial speed of the jog column [m/s]

struct Look {
    QString word;
    StateChip::Shape shape;
    QColor colour;
};

Look verdictLook(doctor::Verdict verdict) {
    const Theme& theme = Theme::current();
    switch (verdict) {
        case doctor::Verdict::Good:
            return {PreflightPage::tr("Good"), StateChip::Shape::Dot, theme.axisTexts[1]};
        case doctor::Verdict::Attention:
            return {PreflightPage::tr("Warning"), StateChip::Shape::WarningTriangle, theme.warning};
        case doctor::Verdict::Bad:
            return {PreflightPage::tr("Failed"), StateChip::Shape::Octagon, theme.alarm};
        case doctor::Verdict::Skipped:
            break;
    }
    return {PreflightPage::tr("Not checked"), StateChip::Shape::Circle, theme.secondary};
}

}  // namespace

class FindingRow::Sign : public QWidget {
public:
    explicit Sign(QWidget* parent) : QWidget(parent) { setFixedSize(20, 20); }
    void showVerdict(doctor::Verdict verdict) {
        verdict_ = verdict;
        update();
    }

protected:
    void paintEvent(QPaintEvent*) override {
        QPainter painter(this);
        const Look look = verdictLook(verdict_);
        drawShape(painter, look.shape, QRectF(2, 2, 16, 16), look.colour, Theme::current().background);
    }

private:
    doctor::Verdict verdict_ = doctor::Verdict::Skipped;
};

int FindingRow::widestTitle() const {
    int widest = kTitle;
    for (int i = 0; i < doctor::kConditionCount; ++i) {
        const QString title = doctor::conditionTitle(static_cast<doctor::Condition>(i));
        widest = std::max(widest, title_->fontMetrics().horizontalAdvance(title) + 2);
    }
    return widest;
}

FindingRow::FindingRow(doctor::Condition condition, QWidget* parent)
    : QWidget(parent)
    , sign_(new Sign(this))
    , title_(new QLabel(doctor::conditionTitle(condition), this))
    , detail_(new QLabel(this))
    , fix_(new QLabel(this)) {
    setObjectName(QStringLiteral("finding.") + doctor::conditionId(condition));
    finding_.condition = condition;
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 2, 0, 2);
    grid->setVerticalSpacing(1);
    grid->addWidget(sign_, 0, 0, Qt::AlignTop);
    grid->addWidget(title_, 0, 1);
    grid->addWidget(detail_, 0, 2);
    grid->addWidget(fix_, 1, 1, 1, 2);
    grid->setColumnMinimumWidth(1, widestTitle());
    grid->setColumnStretch(2, 1);
    detail_->setProperty("role", QStringLiteral("secondary"));
    detail_->setWordWrap(true);
    fix_->setWordWrap(true);
    showWaiting();
}

void FindingRow::showWaiting() {
    sign_->showVerdict(doctor::Verdict::Skipped);
    detail_->setText(QStringLiteral("…"));
    fix_->hide();
    setAccessibleName(title_->text());
}

void FindingRow::showFinding(const doctor::Finding& finding) {
    finding_ = finding;
    sign_->showVerdict(finding.verdict);
    const QString word = verdictLook(finding.verdict).word;
    detail_->setText(finding.detail.isEmpty() ? word : word + QStringLiteral(" · ") + finding.detail);
    fix_->setText(finding.fix);
    fix_->setVisible(!finding.fix.isEmpty());
    setAccessibleName(QStringLiteral("%1: %2. %3").arg(title_->text(), detail_->text(), finding.fix));
}

PreflightPage::PreflightPage(const doctor::Patient& patient, QWidget* parent)
    : QDialog(parent), patient_(patient) {
    setObjectName(QStringLiteral("preflightPage"));
    setWindowTitle(tr("Before you connect to %1").arg(patient.host));
    setAttribute(Qt::WA_DeleteOnClose);
    resize(760, 660);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(24, 20, 24, 20);
    layout->setSpacing(10);
    summary_ = new QLabel(this);
    summary_->setObjectName(QStringLiteral("preflightSummary"));
    summary_->setFont(textFont(20, QFont::Bold));
    summary_->setWordWrap(true);
    layout->addWidget(summary_);

    auto* list = new QWidget(this);
    list_ = new QVBoxLayout(list);
    list_->setContentsMargins(0, 0, 8, 0);
    list_->setSpacing(0);
    for (int i = 0; i < doctor::kConditionCount; ++i) {
        rows_.append(new FindingRow(static_cast<doctor::Condition>(i), list));
        list_->addWidget(rows_.back());
    }
    list_->addStretch(1);
    auto* scroll = new NoFocusScrollArea(this);
    scroll->setObjectName(QStringLiteral("preflightConditions"));
    scroll->setAccessibleName(tr("Checks"));
    scroll->setWidget(list);
    scroll->setWidgetResizable(true);
    list->setAutoFillBackground(false);
    scroll->viewport()->setAutoFillBackground(false);
    layout->addWidget(scroll, 1);

    note_ = new QLabel(this);
    note_->setObjectName(QStringLiteral("safetyNote"));
    note_->setWordWrap(true);
    note_->setProperty("role", QStringLiteral("secondary"));
    layout->addWidget(note_);
    showNote();

    consequence_ =
        new QLabel(tr("If you connect anyway, the window shows the available data. The red items "
                      "above may prevent Tiller from taking control or may stop a running motion."),
                   this);
    consequence_->setObjectName(QStringLiteral("preflightConsequence"));
    consequence_->setWordWrap(true);
    consequence_->hide();
    layout->addWidget(consequence_);

    auto* buttons = new QHBoxLayout;
    again_ = new QPushButton(tr("Check again"), this);
    again_->setObjectName(QStringLiteral("preflightAgain"));
    again_->setAutoDefault(false);
    auto* cancel = new QPushButton(tr("Close"), this);
    cancel->setObjectName(QStringLiteral("preflightClose"));
    cancel->setAutoDefault(false);
    connect_ = new QPushButton(tr("Connect"), this);
    connect_->setObjectName(QStringLiteral("preflightConnect"));
    buttons->addWidget(again_);
    buttons->addStretch(1);
    buttons->addWidget(cancel);
    buttons->addWidget(connect_);
    layout->addLayout(buttons);
    connect(again_, &QPushButton::clicked, this, &PreflightPage::examine);
    connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
    connect(connect_, &QPushButton::clicked, this, [this] {
        accept();  // close this page first, because it would also close a question that the request may open
        Q_EMIT connectRequested();
    });
    examine();
}

void PreflightPage::showNote() {
    note_->setText(tr("Keep everyone out of reach of the arm.\nKeep the emergency stop within reach: STOP in "
                      "this window is a software stop.\nStart slowly: the initial speed is %1.\nWatch the "
                      "arm, not the screen, while you hold a button.\nRelease the button to stop the arm.")
                       .arg(format::speed(kFirstSpeed)));
}

void PreflightPage::changeEvent(QEvent* event) {
    if (event->type() == QEvent::StyleChange && note_ != nullptr) {
        showNote();
    }
    QDialog::changeEvent(event);
}

void PreflightPage::examine() {
    worker_.cancelAll();
    finished_ = false;
    again_->setEnabled(false);
    offer(true);
    summary_->setText(tr("Checking %1…").arg(patient_.host));
    for (FindingRow* row : rows_) {
        row->showWaiting();
    }
    const std::uint64_t run = ++run_;
    worker_.post(this, [this, run, patient = patient_](const CancelToken& token) {
        const doctor::Report report = doctor::examine(patient, Deadline::after(kAtMost, token),
                                                      [this, run](const doctor::Finding& finding) {
                                                          // Capturing `this` is safe, because the destructor
                                                          // of worker_ waits for this job.
                                                          QMetaObject::invokeMethod(
                                                              this,
                                                              [this, run, finding] {
                                                                  if (run == run_) {
                                                                      showFinding(finding);
                                                                  }
                                                              },
                                                              Qt::QueuedConnection);
                                                      });
        return std::function<void()>([this, run, report] {
            if (run == run_) {
                conclude(report);
            }
        });
    });
}

void PreflightPage::showFinding(const doctor::Finding& finding) {
    rows_[static_cast<int>(finding.condition)]->showFinding(finding);
}

void PreflightPage::conclude(const doctor::Report& report) {
    report_ = report;
    finished_ = true;
    again_->setEnabled(true);
    const doctor::Verdict verdict = doctor::overall(report);
    summary_->setText(verdict == doctor::Verdict::Bad         ? tr("Problems found")
                      : verdict == doctor::Verdict::Attention ? tr("Ready, with warnings")
                                                              : tr("Everything is ready"));
    offer(verdict != doctor::Verdict::Bad);
    sortRows();
    Q_EMIT finished();
}

void PreflightPage::offer(bool connecting) {
    connect_->setText(connecting ? tr("Connect") : tr("Connect anyway"));
    consequence_->setVisible(!connecting);
    const auto makePrimary = [](QPushButton* key, bool primary) {
        key->setProperty("primary", primary);
        key->setDefault(primary);
        key->style()->unpolish(key);
        key->style()->polish(key);
    };
    makePrimary(connect_, connecting);
    makePrimary(again_, !connecting);
}

void PreflightPage::sortRows() {
    const auto rank = [](const FindingRow* row) {
        switch (row->finding().verdict) {
            case doctor::Verdict::Bad:
                return 0;
            case doctor::Verdict::Attention:
                return 1;
            case doctor::Verdict::Good:
            case doctor::Verdict::Skipped:
                break;
        }
        return 2;
    };
    // Sort a copy. rows_ must remain in the order of the conditions.
    QVector<FindingRow*> sorted = rows_;
    std::stable_sort(sorted.begin(), sorted.end(),
                     [&](const FindingRow* a, const FindingRow* b) { return rank(a) < rank(b); });
    for (int i = 0; i < sorted.size(); ++i) {
        list_->removeWidget(sorted[i]);
        list_->insertWidget(i, sorted[i]);
    }
    auto* scroll = findChild<QScrollArea*>(QStringLiteral("preflightConditions"));
    scroll->verticalScrollBar()->setValue(0);
}

}  // namespace tiller

#include "moc_preflight_page.cpp"
