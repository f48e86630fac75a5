// SPDX-License-Identifier: GPL-3.0-or-later

#include <QCommandLineParser>
#include <QFileInfo>

#include "app/cli_command.h"
#include "app/cli_options.h"
#include "robot/recording/formats/open_recording.h"
#include "robot/recording/hdf5/episodes.h"

namespace tiller::app {

namespace {

const QString kEpisodesHelp = QStringLiteral(
    "tiller-cli episodes: cuts recordings into demonstrations for imitation learning\n"
    "\n"
    "Usage: tiller-cli episodes FILE... --out FILE.h5 [options]\n"
    "\n"
    "  FILE...              recordings (.mcap, .h5 or .csv)\n"
    "  --out FILE           HDF5 file in the layout of robomimic: /data/demo_0 with obs, next_obs, actions,\n"
    "                       rewards and dones\n"
    "  --cut HOW            program: one episode from each start of a program to its stop (default); notes:\n"
    "                       from each note of the operator to the next; whole: one episode per recording\n"
    "  --rate HZ            rows per second (default 20); 0: all rows\n"
    "  --shortest SECONDS   shorter episodes are omitted (default 0.5)\n"
    "  --observations A,B   observed fields (default actual_q,actual_qd,actual_TCP_pose,actual_TCP_force)\n"
    "  --action FIELD       field with the commanded values (default target_q)\n"
    "  --force              replaces an existing file\n"
    "  --help               shows this text\n"
    "\n"
    "Exit code: 0 file written, 1 file not written or no episode found, 2 invalid arguments.\n");

}  // namespace

int episodes(const QStringList& arguments) {
    QCommandLineParser parser;
    const QCommandLineOption help(QStringList{"h", "help"});
    const QCommandLineOption outFile("out", {}, "FILE");
    const QCommandLineOption cut("cut", {}, "HOW", "program");
    const QCommandLineOption rate("rate", {}, "HZ", "20");
    const QCommandLineOption shortest("shortest", {}, "SECONDS", "0.5");
    const QCommandLineOption observations("observations", {}, "A,B");
    const QCommandLineOption action("action", {}, "FIELD", "target_q");
    const QCommandLineOption force("force");
    parser.addOptions({help, outFile, cut, rate, shortest, observations, action, force});
    if (!parser.parse(arguments)) {
        return wrongArguments(parser.errorText());
    }
    if (parser.isSet(help)) {
        out() << kEpisodesHelp;
        out().flush();
        return kSuccess;
    }
    const QString target = parser.value(outFile);
    if (parser.positionalArguments().isEmpty() || target.isEmpty()) {
        return wrongArguments(QStringLiteral("episodes: recordings and --out FILE.h5 are required"));
    }
    if (!parser.isSet(force) && QFileInfo::exists(target)) {
        return wrongArguments(QStringLiteral("episodes: %1 already exists; --force replaces it").arg(target));
    }
    recording::EpisodeChoice choice;
    const QString how = parser.value(cut);
    if (how == QLatin1String("notes")) {
        choice.cut = recording::EpisodeChoice::Cut::Notes;
    } else if (how == QLatin1String("whole")) {
        choice.cut = recording::EpisodeChoice::Cut::Whole;
    } else if (how != QLatin1String("program")) {
        return wrongArguments(QStringLiteral("--cut must be program, notes or whole, not '%1'").arg(how));
    }
    const auto hertz = numberIn(parser, rate, 0, 10'000);
    const auto least = numberIn(parser, shortest, 0, 1e6);
    if (!hertz || !least) {
        return kWrongArguments;
    }
    choice.rate = *hertz;
    choice.shortest = *least;
    if (parser.isSet(observations)) {
        choice.observations = namesIn(parser.value(observations));
    }
    choice.action = parser.value(action).toStdString();
    std::vector<std::unique_ptr<recording::Recording>> opened;
    std::vector<const recording::Recording*> recordings;
    for (const QString& path : parser.positionalArguments()) {
        auto file = recording::openRecording(path);
        if (!file) {
            return complain(file.error().toString(), kFailed);
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

}  // namespace tiller::app
