// SPDX-License-Identifier: GPL-3.0-or-later

#include <QFileInfo>

#include "app/cli_command.h"
#include "app/cli_options.h"
#include "robot/recording/formats/open_recording.h"
#include "robot/recording/hdf5/episodes.h"

namespace tiller::app {

namespace {

int episodes(const CommandArguments& arguments) {
    const QString target = arguments.value("out");
    if (arguments.operands().isEmpty() || target.isEmpty()) {
        return wrongArguments(QStringLiteral("episodes: recordings and --out FILE.h5 are required"));
    }
    if (!arguments.isSet("force") && QFileInfo::exists(target)) {
        return wrongArguments(QStringLiteral("episodes: %1 already exists; --force replaces it").arg(target));
    }
    recording::EpisodeChoice choice;
    const QString how = arguments.value("cut");
    if (how == QLatin1String("notes")) {
        choice.cut = recording::EpisodeChoice::Cut::Notes;
    } else if (how == QLatin1String("whole")) {
        choice.cut = recording::EpisodeChoice::Cut::Whole;
    } else if (how != QLatin1String("program")) {
        return wrongArguments(QStringLiteral("--cut must be program, notes or whole, not '%1'").arg(how));
    }
    choice.rate = arguments.number("rate");
    choice.shortest = arguments.number("shortest");
    if (arguments.isSet("observations")) {
        choice.observations = namesIn(arguments.value("observations"));
    }
    choice.action = arguments.value("action").toStdString();
    const auto format = tableFormatOf(arguments);
    if (!format) {
        return wrongArguments(format.error().context);
    }
    std::vector<std::unique_ptr<recording::Recording>> opened;
    std::vector<const recording::Recording*> recordings;
    for (const QString& path : arguments.operands()) {
        auto file = recording::openRecording(path, *format);
        if (!file) {
            return complain(file.error().toString(), exitCodeOf(file.error()));
        }
        opened.push_back(std::move(file).value());
        recordings.push_back(opened.back().get());
    }
    const auto report = recording::writeEpisodes(recordings, target, choice);
    if (!report) {
        return complain(report.error().toString(), kFailed);
    }
    out() << QStringLiteral("%1: %2 episodes, %3 rows, %4 too short")
                 .arg(target)
                 .arg(report.value().episodes)
                 .arg(report.value().rows)
                 .arg(report.value().tooShort)
          << Qt::endl;
    return kSuccess;
}

}  // namespace

const Command& episodesCommand() {
    static const Command kCommand{
        .name = "episodes",
        .operands = "FILE...",
        .summary = "splits recordings into demonstrations for imitation learning",
        .title = "splits recordings into demonstrations for imitation learning",
        .usage = {"FILE... --out FILE.h5 [options]"},
        .operandRows = {recordingOperand("FILE...")},
        .options = withTableOptions(
            {{"out", "FILE",
              "HDF5 file in robomimic layout: /data/demo_0 with obs, next_obs, actions, rewards and dones"},
             {"cut", "HOW",
              "program: one episode from each start of a program to its stop (default); "
              "notes: from each note of the operator to the next; whole: one episode per "
              "recording",
              "program"},
             {"rate", "HZ", "rows per second (default %1); 0: all rows", "20", {0, 10'000}},
             {"shortest", "SECONDS", "omits episodes shorter than this time (default %1)", "0.5", {0, 1e6}},
             {"observations", "A,B",
              "observed fields (default actual_q,actual_qd,actual_TCP_pose,actual_TCP_force)"},
             {"action", "FIELD", "field with the commanded values (default %1)", "target_q"},
             {"force", "", "replaces an existing file"}}),
        .notes =
            "Exit code: 0 the file was written, 1 the file was not written or no episode was found, 2 "
            "invalid arguments.",
        .run = episodes};
    return kCommand;
}

}  // namespace tiller::app
