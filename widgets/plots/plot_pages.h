// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The plot pages with their tabs. All pages share the same time range and cursors.

#include <QDateTime>
#include <QWidget>
#include <functional>
#include <vector>

#include "widgets/plots/plot_layout.h"

class QStackedWidget;
class QTabBar;

namespace tiller {

class PlotMarks;
class PlotView;
class SignalStore;
class StateLane;

class PlotPages : public QWidget {
    Q_OBJECT

public:
    PlotPages(SignalStore& store, const StateLane& lane, PlotMarks& marks, QWidget* parent = nullptr);

    PlotView& view() const;
    int count() const;
    int current() const;
    void setCurrent(int page);
    /// Adds an empty page and shows it.
    void addPage();
    /// Returns  false, without adding a page, if there are already kMaxPages pages
    bool addPage(const PageLayout& page);
    /// Removes all signals of recordings, and the pages that showed nothing else, except pages that the user
    /// has renamed.
    void dropRecordings();
    /// Removes a page. The last remaining page is instead reset to the standard plots.
    void removePage(int page);
    void rename(int page, const QString& name);
    QString nameOf(int page) const;
    /// Index of the page with signals of this recording; -1 if there is none.
    int pageOf(const QString& recording) const;
    /// Index of the current page if it shows no recordings, otherwise of the first page without recordings;
    /// -1 if there is none.
    int livePage() const;
    /// Shows the newest samples on a live page, with the time span used before the recording was shown.
    void returnToLive();

    TimeAxis timeAxis() const { return timeAxis_; }
    void setTimeAxis(TimeAxis axis);
    /// Sets a function that returns the time of day for a time on the time axis.
    void setClock(std::function<QDateTime(double)> clock);

    /// Replaces the pages without recordings by one page with the standard plots, and shows the newest
    /// samples on it.
    /// Returns  false, without changes, if all kMaxPages pages show recordings
    bool showStandard();

    PlotLayout arrangement() const;
    void arrange(const PlotLayout& layout);

    void refresh(double seconds);
    void clearZero();

Q_SIGNALS:
    void windowChanged();
    void readoutChanged();
    void readoutAged();
    void zeroChanged();
    void tooManySignals();
    void noteWanted(double time);
    /// Pages, plots or signals have changed, or another page was selected.
    void arrangementChanged();

protected:
    void changeEvent(QEvent* event) override;

private:
    PlotView& addView();
    bool hasRecording(int page) const;
    /// Removes the signals of recordings, and signals that do not exist, from the page.
    /// Returns  true if any were removed
    bool takeRecordingsFrom(PageLayout& page) const;
    void turnedTo(int page);
    void nameTabs();

    SignalStore& store_;
    const StateLane& lane_;
    PlotMarks& marks_;
    QTabBar* tabs_;
    QStackedWidget* stack_;
    std::vector<PlotView*> views_;
    int shown_ = 0;
    double liveSpan_ = 0;     // span of the live page before a recording was shown [s]; 0: not stored
    double carriedSpan_ = 0;  // span that the live page has taken over from a recording [s]
    TimeAxis timeAxis_ = TimeAxis::Relative;
    std::function<QDateTime(double)> clock_;
};

}  // namespace tiller
