// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/plot_comparison.h"

#include <algorithm>

#include "robot/recording/formats/open_recording.h"
#include "robot/station/history/comparison_text.h"
#include "robot/station/history/plot_marks.h"
#include "robot/station/history/signal_store.h"
#include "robot/station/link/robot_session.h"
#include "robot/station/text/format.h"
#include "widgets/plots/comparison_band.h"
#include "widgets/plots/comparison_dialog.h"
#include "widgets/plots/plot_pages.h"
#include "widgets/plots/plot_replay.h"
#include "widgets/plots/plot_view.h"

namespace tiller {

PlotComparison::PlotComparison(const Place& place, QObject* parent) : QObject(parent), place_(place) {
    connect(&place_.band, &ComparisonBand::cancelWanted, this, [this] { cancel(recordingInFront()); });
    connect(&place_.band, &ComparisonBand::momentWanted, this, &PlotComparison::goThere);
    connect(&place_.band, &ComparisonBand::comparisonWanted, this, [this] { ask(recordingInFront()); });
}

PlotComparison::~PlotComparison() {
    forgetAll();
}

QString PlotComparison::recordingInFront() const {
    return place_.pages.view().recordingsShown().value(0);
}

std::optional<RobotModelId> PlotComparison::modelOf(const QString& recording) const {
    const recording::Recording* file = place_.store.recorded(recording);
    if (file == nullptr) {
        return std::nullopt;
    }
    const auto said = file->facts().find("model");
    if (said != file->facts().end() && !said->second.empty()) {
        return robotModelByName(QString::fromStdString(said->second));
    }
    const auto robot = file->facts().find("robot");
    const bool same = robot != file->facts().end() &&
                      robot->second == place_.session.address().host.toStdString() &&
                      place_.session.state().hasData();
    return same ? std::optional(place_.session.state().model) : std::nullopt;
}

void PlotComparison::begin(const QString& recording) {
    run(recording, modelOf(recording));
}

void PlotComparison::ask(const QString& recording) {
    if (place_.store.recorded(recording) == nullptr) {
        return;
    }
    const auto known = entries_.constFind(recording);
    ComparisonDialog dialog(limits_,
                            known != entries_.constEnd() && known->model ? known->model : modelOf(recording),
                            &place_.pages);
    if (dialog.exec() != QDialog::Accepted || place_.store.recorded(recording) == nullptr) {
        return;
    }
    if (!(dialog.limits() == limits_)) {
        limits_ = dialog.limits();
        Q_EMIT limitsChanged();
    }
    run(recording, dialog.model());
}

void PlotComparison::run(const QString& recording, std::optional<RobotModelId> model) {
    const recording::Recording* file = place_.store.recorded(recording);
    if (file == nullptr) {
        return;
    }
    cancel(recording);
    Entry entry;
    entry.run = ++runs_;
    entry.model = model;
    if (!model) {
        entry.state = State::Failed;
        entry.problem =
            tr("Not compared with the arm model: the recording does not specify the robot model. Press "
               "“Compare…” and select the model.");
    }
    const CancelToken cancel = entry.cancel;
    entries_.insert(recording, entry);
    place_.marks.forgetAlarmsOf(recording);
    place_.replay.setFurtherEvents(recording, {});
    if (model) {
        divergence::Choice choice;
        choice.limits = limits_;
        choice.model = model;
        // Open the file again, because the plots use their own instance.
        worker_.post(this, [this, recording, choice, cancel, number = entry.run,
                            path = file->path()](const CancelToken& ending) {
            auto mine = choice;
            int reported = -1;
            mine.progress = [&](double done) {
                constexpr double kSteps = 50;
                if (const int now = static_cast<int>(done * kSteps); now != reported) {
                    reported = now;
                    QMetaObject::invokeMethod(
                        this, [=, this] { progress(recording, number, done); }, Qt::QueuedConnection);
                }
                return !cancel.isCancelled() && !ending.isCancelled();
            };
            const auto opened = recording::openRecording(path);
            const Result<divergence::Report> result = opened ? divergence::compare(*opened.value(), mine)
                                                             : Result<divergence::Report>(opened.error());
            return std::function<void()>([=, this] { finish(recording, number, result); });
        });
    }
    follow();
}

void PlotComparison::cancel(const QString& recording) {
    if (const auto entry = entries_.constFind(recording); entry != entries_.constEnd()) {
        entry->cancel.cancel();
    }
}

void PlotComparison::forgetAll() {
    for (const Entry& entry : std::as_const(entries_)) {
        entry.cancel.cancel();
    }
    entries_.clear();
}

void PlotComparison::progress(const QString& recording, std::uint64_t run, double done) {
    if (const auto entry = entries_.find(recording); entry != entries_.end() && entry->run == run) {
        entry->done = done;
        follow();
    }
}

void PlotComparison::finish(const QString& recording, std::uint64_t run,
                            const Result<divergence::Report>& result) {
    const auto entry = entries_.find(recording);
    const recording::Recording* file = place_.store.recorded(recording);
    if (entry == entries_.end() || entry->run != run || file == nullptr) {
        return;
    }
    // Discard the result of a cancelled comparison.
    const Error none = entry->cancel.isCancelled() ? Error{ErrorCode::Cancelled, {}, {}}
                       : result                    ? Error{}
                                                   : result.error();
    if (none.code != ErrorCode::None) {
        entry->state = State::Failed;
        entry->problem = comparisonError(none);
        follow();
        return;
    }
    entry->state = State::Done;
    entry->report = *result;
    mark(recording, *result);
    follow();
    if (!result->first()) {
        return;
    }
    const QString text = reportText(*result);
    if (const QString once = file->path() + QLatin1Char('\n') + text; !told_.contains(once)) {
        told_.insert(once);
        Q_EMIT parted(text, reportDetails(*result), file->path(), result->first()->seconds);
    }
}

void PlotComparison::mark(const QString& recording, const divergence::Report& report) {
    const auto first = report.first();
    if (!first) {
        return;
    }
    place_.marks.addOf(recording, {place_.store.timesOf(recording)->firstTime() + first->seconds,
                                   tr("Arm and model diverge: %1").arg(deviationMark(*first)), true});
    constexpr int kWarning = 30;
    place_.replay.setFurtherEvents(
        recording, {{first->seconds, kWarning, QStringLiteral("tiller"), deviationText(*first)}});
}

void PlotComparison::goThere() {
    const QString recording = recordingInFront();
    const auto entry = entries_.constFind(recording);
    if (entry == entries_.constEnd() || !entry->report.first()) {
        return;
    }
    place_.pages.view().goTo(place_.store.timesOf(recording)->firstTime() + entry->report.first()->seconds);
}

QString PlotComparison::words() const {
    return place_.band.isHidden() ? QString() : place_.band.words();
}

void PlotComparison::follow() {
    const auto entry = entries_.constFind(recordingInFront());
    const bool shown = entry != entries_.constEnd();
    if (shown) {
        using Key = ComparisonBand::Key;
        switch (entry->state) {
            case State::Running:
                place_.band.tell(tr("Comparing the arm with its model: %1").arg(format::percent(entry->done)),
                                 {}, Key::Cancel, false);
                break;
            case State::Done:
                place_.band.tell(reportText(entry->report), reportDetails(entry->report),
                                 entry->report.first() ? Key::GoThere : Key::None,
                                 entry->report.first().has_value());
                break;
            case State::Failed:
                place_.band.tell(entry->problem, {}, Key::None, false);
                break;
        }
    }
    if (shown == place_.band.isHidden()) {
        place_.band.setVisible(shown);
        Q_EMIT bandChanged();
    }
}

}  // namespace tiller

#include "moc_plot_comparison.cpp"
