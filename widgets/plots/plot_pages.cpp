// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/plot_pages.h"

#include <QEvent>
#include <QInputDialog>
#include <QStackedWidget>
#include <QTabBar>
#include <QVBoxLayout>
#include <algorithm>

#include "robot/station/history/plot_marks.h"
#include "robot/station/history/signal_store.h"
#include "widgets/common/theme.h"
#include "widgets/plots/plot_view.h"

namespace tiller {

PlotPages::PlotPages(SignalStore& store, const StateLane& lane, PlotMarks& marks, QWidget* parent)
    : QWidget(parent)
    , store_(store)
    , lane_(lane)
    , marks_(marks)
    , tabs_(new QTabBar)
    , stack_(new QStackedWidget) {
    tabs_->setObjectName(QStringLiteral("plots.pages"));
    tabs_->setAccessibleName(tr("Plot pages"));
    tabs_->setDrawBase(false);
    tabs_->setExpanding(false);
    tabs_->setTabsClosable(true);
    tabs_->setFont(textFont(13));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(tabs_);
    layout->addWidget(stack_, 1);
    addView();
    nameTabs();
    connect(tabs_, &QTabBar::currentChanged, this, &PlotPages::turnedTo);
    connect(tabs_, &QTabBar::tabCloseRequested, this, &PlotPages::removePage);
    connect(tabs_, &QTabBar::tabBarDoubleClicked, this, [this](int page) {
        bool done = false;
        const QString name = page < 0 ? QString()
                                      : QInputDialog::getText(this, tr("Page name"), tr("Name"),
                                                              QLineEdit::Normal, nameOf(page), &done);
        if (done) {
            rename(page, name);
        }
    });
}

PlotView& PlotPages::view() const {
    return *views_[static_cast<std::size_t>(shown_)];
}

int PlotPages::count() const {
    return static_cast<int>(views_.size());
}

int PlotPages::current() const {
    return shown_;
}

PlotView& PlotPages::addView() {
    auto* view = new PlotView(store_, lane_, marks_);
    view->setTimeAxis(timeAxis_, clock_);
    views_.push_back(view);
    stack_->addWidget(view);
    {
        const QSignalBlocker quiet(tabs_);
        tabs_->addTab(QString());
    }
    connect(view, &PlotView::windowChanged, this, &PlotPages::windowChanged);
    connect(view, &PlotView::readoutChanged, this, &PlotPages::readoutChanged);
    connect(view, &PlotView::readoutAged, this, &PlotPages::readoutAged);
    connect(view, &PlotView::zeroChanged, this, &PlotPages::zeroChanged);
    connect(view, &PlotView::tooManySignals, this, &PlotPages::tooManySignals);
    connect(view, &PlotView::noteWanted, this, &PlotPages::noteWanted);
    connect(view, &PlotView::pageChanged, this, &PlotPages::arrangementChanged);
    return *view;
}

void PlotPages::setCurrent(int page) {
    tabs_->setCurrentIndex(page);
}

void PlotPages::turnedTo(int page) {
    if (page < 0 || page >= count() || page == shown_) {
        return;
    }
    PlotView& before = view();
    const double span = before.window().span();
    const bool wasLive = before.recordingsShown().isEmpty();
    shown_ = page;
    const bool isLive = view().recordingsShown().isEmpty();
    if (wasLive && !isLive && span != carriedSpan_) {
        liveSpan_ = span;
    } else if (!wasLive && isLive) {
        carriedSpan_ = span;
    }
    view().showLike(before, false);
    stack_->setCurrentIndex(page);
    view().setFocus(Qt::OtherFocusReason);
    Q_EMIT zeroChanged();
    Q_EMIT windowChanged();
    Q_EMIT arrangementChanged();
}

void PlotPages::addPage() {
    PageLayout page;
    page.panes = {{}};
    addPage(page);
}

bool PlotPages::takeRecordingsFrom(PageLayout& page) const {
    bool any = false;
    const auto keep = [&](QStringList& keys) {
        any = keys.removeIf([this](const QString& key) {
            const int signal = store_.find(key);
            return signal < 0 || store_.isRecorded(signal);
        }) > 0 ||
              any;
    };
    for (PaneLayout& pane : page.panes) {
        keep(pane.shown);
        keep(pane.hidden);
        pane.styles.removeIf([&pane](const auto& style) { return !pane.shown.contains(style.key()); });
    }
    keep(page.lanes);
    return any;
}

void PlotPages::dropRecordings() {
    for (int i = count() - 1; i >= 0; --i) {
        PlotView* view = views_[static_cast<std::size_t>(i)];
        PageLayout page = view->page();
        const bool had = takeRecordingsFrom(page);
        view->setPage(page);
        const bool isNamed =
            !page.name.isEmpty() && store_.recorded(page.name) == nullptr;  // named by the operator
        if (had && !isNamed && page.lanes.isEmpty() &&
            std::all_of(page.panes.begin(), page.panes.end(), [](const PaneLayout& pane) {
                return pane.shown.isEmpty() && pane.hidden.isEmpty();
            })) {
            removePage(i);
        }
    }
}

int PlotPages::pageOf(const QString& recording) const {
    for (int page = 0; page < count(); ++page) {
        const QSet<int> shown = views_[static_cast<std::size_t>(page)]->signalsShown();
        if (std::any_of(shown.begin(), shown.end(),
                        [&](int signal) { return store_.recordingOf(signal) == recording; })) {
            return page;
        }
    }
    return -1;
}

bool PlotPages::hasRecording(int page) const {
    const QSet<int> shown = views_[static_cast<std::size_t>(page)]->signalsShown();
    return std::any_of(shown.begin(), shown.end(), [this](int signal) { return store_.isRecorded(signal); });
}

int PlotPages::livePage() const {
    if (!hasRecording(shown_)) {
        return shown_;
    }
    for (int page = 0; page < count(); ++page) {
        if (!hasRecording(page)) {
            return page;
        }
    }
    return -1;
}

void PlotPages::returnToLive() {
    const int live = livePage();
    const bool isCarried = live != shown_ || view().window().span() == carriedSpan_;
    if (live >= 0) {
        setCurrent(live);
        if (isCarried && liveSpan_ > 0) {
            view().setSpan(liveSpan_);
        }
    }
    liveSpan_ = carriedSpan_ = 0;
    view().follow();
}

bool PlotPages::addPage(const PageLayout& page) {
    if (count() >= PlotLayout::kMaxPages) {
        return false;
    }
    addView().setPage(page);
    nameTabs();
    setCurrent(count() - 1);
    Q_EMIT arrangementChanged();
    return true;
}

void PlotPages::removePage(int page) {
    if (page < 0 || page >= count()) {
        return;
    }
    if (count() == 1) {
        view().setPage(PageLayout::standard());
        return;
    }
    const int next = page == shown_ ? (page == 0 ? 1 : page - 1) : shown_;
    setCurrent(next);
    PlotView* gone = views_[static_cast<std::size_t>(page)];
    views_.erase(views_.begin() + page);
    shown_ = next > page ? next - 1 : next;
    {
        const QSignalBlocker quiet(tabs_);
        tabs_->removeTab(page);
        tabs_->setCurrentIndex(shown_);
    }
    stack_->removeWidget(gone);
    gone->deleteLater();
    stack_->setCurrentIndex(shown_);
    nameTabs();
    Q_EMIT arrangementChanged();
}

void PlotPages::rename(int page, const QString& name) {
    PageLayout named = views_[static_cast<std::size_t>(page)]->page();
    named.name = name.trimmed().left(60);
    views_[static_cast<std::size_t>(page)]->setPage(named);
    nameTabs();
}

QString PlotPages::nameOf(int page) const {
    const QString name = views_[static_cast<std::size_t>(page)]->page().name;
    return name.isEmpty() ? tr("Page %1").arg(page + 1) : name;
}

void PlotPages::nameTabs() {
    for (int page = 0; page < count(); ++page) {
        tabs_->setTabText(page, nameOf(page));
        tabs_->setTabToolTip(page, tr("Double-click to rename"));
    }
    tabs_->setVisible(count() > 1);
}

void PlotPages::setTimeAxis(TimeAxis axis) {
    if (axis == timeAxis_) {
        return;
    }
    timeAxis_ = axis;
    for (PlotView* view : views_) {
        view->setTimeAxis(timeAxis_, clock_);
    }
    Q_EMIT arrangementChanged();
}

void PlotPages::setClock(std::function<QDateTime(double)> clock) {
    clock_ = std::move(clock);
    for (PlotView* view : views_) {
        view->setTimeAxis(timeAxis_, clock_);
    }
}

PlotLayout PlotPages::arrangement() const {
    PlotLayout layout;
    layout.pages.clear();
    for (int i = 0; i < count(); ++i) {
        const PlotView& view = *views_[static_cast<std::size_t>(i)];
        PageLayout page = view.page();
        // Do not save signals of files, because a file may not exist at the next start.
        const bool had = takeRecordingsFrom(page);
        const bool any = !page.lanes.isEmpty() ||
                         std::any_of(page.panes.begin(), page.panes.end(),
                                     [](const PaneLayout& pane) { return !pane.shown.isEmpty(); });
        if (!had || any) {
            layout.current = i <= shown_ ? static_cast<int>(layout.pages.size()) : layout.current;
            layout.pages.append(page);
        }
    }
    if (layout.pages.isEmpty()) {
        layout.pages.append(PageLayout::standard());
    }
    layout.span = view().window().span();
    layout.time = timeAxis_;
    layout.thresholds = marks_.thresholds();
    return layout;
}

void PlotPages::arrange(const PlotLayout& layout) {
    const int wanted = std::clamp(static_cast<int>(layout.pages.size()), 1, PlotLayout::kMaxPages);
    while (count() > wanted) {
        removePage(count() - 1);
    }
    while (count() < wanted) {
        addView();
    }
    for (int page = 0; page < wanted; ++page) {
        views_[static_cast<std::size_t>(page)]->setPage(layout.pages.value(page, PageLayout::standard()));
    }
    marks_.setThresholds(layout.thresholds);
    setTimeAxis(layout.time);
    nameTabs();
    setCurrent(std::clamp(layout.current, 0, wanted - 1));
    view().setSpan(layout.span);
    Q_EMIT arrangementChanged();
}

bool PlotPages::showStandard() {
    int live = livePage();
    if (live < 0) {
        if (count() >= PlotLayout::kMaxPages) {
            return false;
        }
        addView();
        live = count() - 1;
    }
    setCurrent(live);
    for (int page = count() - 1; page >= 0; --page) {
        if (page != shown_ && !hasRecording(page)) {
            removePage(page);
        }
    }
    const PlotLayout standard;
    view().setPage(standard.pages.front());
    marks_.setThresholds(standard.thresholds);
    setTimeAxis(standard.time);
    nameTabs();
    view().setSpan(standard.span);
    liveSpan_ = carriedSpan_ = 0;
    view().setCursor(PlotView::Cursor::A, std::nullopt);
    view().follow();
    Q_EMIT arrangementChanged();
    return true;
}

void PlotPages::refresh(double seconds) {
    view().refresh(seconds);
}

void PlotPages::clearZero() {
    for (PlotView* view : views_) {
        view->clearZero();
    }
}

void PlotPages::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::StyleChange) {
        tabs_->setFont(textFont(13));
    }
}

}  // namespace tiller

#include "moc_plot_pages.cpp"
