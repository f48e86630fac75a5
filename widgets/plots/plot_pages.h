// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The pages of plots behind their tabs. All show the same stretch of time and the same cursors: whoever turns a page
// goes on where the other one was.

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

    PlotView& view() const;  ///< Of the page in front.
    int count() const;
    int current() const;
    void setCurrent(int page);
    /// An empty page behind the others, and turns to it.
    void addPage();
    /// Returns  false, and adds none, where there are as many as there may be
    bool addPage(const PageLayout& page);
    /// Takes everything away that the robot does not send: nobody shows a recording any more.
    void dropRecordings();
    /// The last one stays, with the standard plots.
    void removePage(int page);
    void rename(int page, const QString& name);
    QString nameOf(int page) const;
    /// The page that shows signals of this recording; -1: there is none.
    int pageOf(const QString& recording) const;
    /// The one in front, or else the first one, that shows no recording; -1: all do.
    int livePage() const;

    TimeAxis timeAxis() const { return timeAxis_; }
    void setTimeAxis(TimeAxis axis);
    /// Who knows the time of the day of a moment on the time axis.
    void setClock(std::function<QDateTime(double)> clock);

    PlotLayout arrangement() const;
    void arrange(const PlotLayout& layout);

    void refresh(double seconds);
    void clearZero();

Q_SIGNALS:
    void windowChanged();
    void readoutChanged();
    void zeroChanged();
    void tooManySignals();
    void noteWanted(double time);
    /// Pages, plots or their signals are others, or another page is in front.
    void arrangementChanged();

protected:
    void changeEvent(QEvent* event) override;

private:
    PlotView& addView();
    /// Returns  whether there was anything of a recording on the page
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
    TimeAxis timeAxis_ = TimeAxis::Relative;
    std::function<QDateTime(double)> clock_;
};

}  // namespace tiller
