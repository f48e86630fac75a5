// SPDX-License-Identifier: GPL-3.0-or-later

#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QLocale>
#include <chrono>

#include "app/cli_command.h"
#include "app/cli_options.h"
#include "app/cli_progress.h"
#include "app/termination.h"
#include "robot/core/file_reading.h"
#include "robot/dashboard/robot_identity.h"
#include "robot/receive/robot_state.h"
#include "robot/recording/formats/file_formats.h"
#include "robot/recording/recorder.h"
#include "tiller_version.h"

namespace tiller::app {

namespace {

using recording::FormatSet;
using recording::RecorderState;
using std::chrono::duration;
using std::chrono::milliseconds;
using std::chrono::steady_clock;

constexpr milliseconds kLookEvery{100};
constexpr std::chrono::seconds kIdentityTimeout{2};

struct RecordOptions {
    receive::ReceiverOptions receiver;
    recording::RecorderOptions recorder;
    recording::McapFormatOptions extras;
    double duration = 0;  ///< [s]; 0: no limit
    double wait = 10;     ///< [s]
    int portOffset = 0;
    const recording::FileFormat* format = nullptr;
    bool csvHead = false;
    bool quiet = false;
};

/// Format of the files that --out-folder names.
const recording::FileFormat& newFileFormat() {
    return *recording::formatsIn(FormatSet::Complete).front();
}

QString newFileIn(const QString& folder, QString address) {
    // Some systems do not allow these characters in file names.
    address.replace(QLatin1Char(':'), QLatin1Char('_')).replace(QLatin1Char('%'), QLatin1Char('_'));
    const QString name = QStringLiteral("%1-%2").arg(
        address, QDateTime::currentDateTimeUtc().toString(QStringLiteral("yyyyMMddTHHmmss")));
    const QString ending = QLatin1Char('.') + newFileFormat().suffixes.constFirst();
    QString path = QDir(folder).filePath(name + ending);
    for (int number = 2; QFileInfo::exists(path); ++number) {
        path = QDir(folder).filePath(QStringLiteral("%1-%2%3").arg(name).arg(number).arg(ending));
    }
    return path;
}

/// Returns an empty value after printing an error.
std::optional<RecordOptions> optionsFrom(const CommandArguments& arguments) {
    if (arguments.operands().size() != 1) {
        wrongArguments(QStringLiteral("record: the address of one robot is required, such as 192.168.0.10"));
        return std::nullopt;
    }
    const QString address = arguments.operands().constFirst();
    if (!isHostName(address)) {
        wrongArguments(QStringLiteral("record: '%1' is not an address or a host name").arg(address));
        return std::nullopt;
    }
    if (arguments.isSet("out") && arguments.isSet("out-folder")) {
        wrongArguments(QStringLiteral("record: --out and --out-folder cannot be combined"));
        return std::nullopt;
    }
    RecordOptions options;
    const QString path = arguments.isSet("out-folder") ? newFileIn(arguments.value("out-folder"), address)
                                                       : arguments.value("out");
    options.format = recording::fileFormatOf(path);
    if (options.format == nullptr || options.format->recorder == nullptr) {
        wrongArguments(path.isEmpty() ? QStringLiteral("record: %1 is missing")
                                            .arg(recording::suffixWords(FormatSet::Recorded,
                                                                        QStringLiteral("--out FILE")))
                                      : QStringLiteral("record: '%1' must end in %2")
                                            .arg(path, recording::suffixWords(FormatSet::Recorded)));
        return std::nullopt;
    }
    const bool isNumbered =
        arguments.isSet("trigger") || arguments.isSet("file-minutes") || arguments.isSet("file-size");
    if (!arguments.isSet("force") && !isNumbered && QFileInfo::exists(path)) {
        wrongArguments(QStringLiteral("record: %1 already exists; --force replaces it").arg(path));
        return std::nullopt;
    }
    options.duration = arguments.number("duration");
    options.wait = arguments.number("wait");
    options.quiet = arguments.isSet("quiet");
    options.receiver.host = address;
    options.receiver.port =
        static_cast<std::uint16_t>(rtde::kPort + static_cast<int>(arguments.number("port-offset")));
    options.portOffset = static_cast<int>(arguments.number("port-offset"));
    options.recorder.path = path;
    options.recorder.every = static_cast<int>(arguments.number("every"));
    options.recorder.keepFree = static_cast<std::int64_t>(arguments.number("keep-free") * 1e6);
    options.recorder.fields = namesIn(arguments.value("fields"));
    if (!options.recorder.fields.empty()) {
        options.receiver.fields = options.recorder.fields;
    } else if (!options.format->isComplete) {
        options.recorder.fields = recording::defaultRecordedFields();
    }
    if (arguments.isSet("trigger")) {
        auto parsed = recording::RecordingTrigger::parse(arguments.value("trigger"));
        if (!parsed) {
            wrongArguments(QStringLiteral("--trigger: %1: %2")
                               .arg(parsed.error().context, parsed.error().controllerMessage));
            return std::nullopt;
        }
        options.recorder.trigger = std::move(parsed).value();
        options.recorder.trigger->before = arguments.number("before");
        options.recorder.trigger->after = arguments.number("after");
        options.recorder.trigger->files = static_cast<int>(arguments.number("files"));
        options.extras.facts["trigger"] = arguments.value("trigger").simplified().toStdString();
    }
    constexpr double kSecondsPerMinute = 60;
    constexpr double kBytesPerMegabyte = 1e6;
    options.recorder.fileSeconds = arguments.number("file-minutes") * kSecondsPerMinute;
    options.recorder.fileBytes = static_cast<std::int64_t>(arguments.number("file-size") * kBytesPerMegabyte);
    options.extras.ros = !arguments.isSet("no-ros");
    for (const QString& entry : arguments.values("meta")) {
        if (const auto added = recording::addMetadata(options.extras.facts, entry); !added) {
            wrongArguments(QStringLiteral("--meta '%1': %2").arg(entry, added.error().controllerMessage));
            return std::nullopt;
        }
    }
    options.csvHead = arguments.isSet("head") || arguments.isSet("meta");
    if (arguments.isSet("attach")) {
        constexpr qint64 kMaxValue = 64 << 20;
        const Result<QByteArray> attached = readWholeFile(arguments.value("attach"), kMaxValue);
        if (!attached) {
            wrongArguments(QStringLiteral("--attach: '%1' cannot be read, or is larger than 64 MB")
                               .arg(arguments.value("attach")));
            return std::nullopt;
        }
        options.extras.attachmentName = QFileInfo(arguments.value("attach")).fileName().toStdString();
        options.extras.attachment = attached->toStdString();
    }
    return options;
}

QString describe(const recording::RecorderProgress& progress, const receive::Receiver& receiver) {
    if (progress.state == RecorderState::Waiting) {
        return QStringLiteral("waiting for the trigger; %n files so far")
            .replace("%n", QString::number(progress.files));
    }
    const double rate = progress.seconds > 0 ? static_cast<double>(progress.bytes) / progress.seconds : 0;
    return QStringLiteral("%1 s  %2 rows  %3 lost  %4  %5/s  %6 Hz  %7 free")
        .arg(progress.seconds, 0, 'f', 1)
        .arg(progress.rows)
        .arg(progress.lost)
        .arg(QLocale::c().formattedDataSize(progress.bytes),
             QLocale::c().formattedDataSize(static_cast<qint64>(rate)))
        .arg(receiver.counters().rateHz, 0, 'f', 0)
        .arg(QLocale::c().formattedDataSize(progress.freeBytes));
}

int record(const CommandArguments& arguments) {
    std::optional<RecordOptions> options = optionsFrom(arguments);
    if (!options) {
        return kWrongArguments;
    }
    holdTerminationSignals();
    receive::Receiver receiver(options->receiver);
    if (const auto started = receiver.start(); !started) {
        return complain(started.error().controllerMessage, kWrongArguments);
    }
    if (auto came =
            receiver.waitForData(Deadline::after(duration<double>(options->wait)), receive::OnRefusal::Wait);
        !came) {
        return complain(
            QStringLiteral("no data from %1: %2").arg(options->receiver.host, came.error().toString()),
            kFailed);
    }
    const SoftwareVersion version = receiver.version();
    options->extras.facts["robot"] = options->receiver.host.toStdString();
    options->extras.facts["software"] = toString(version);
    if (options->format->isComplete || options->csvHead) {
        const auto identity = dashboard::askIdentity(options->receiver.host, options->portOffset,
                                                     version.isCb3(), Deadline::after(kIdentityTimeout));
        options->extras.facts["model"] = identity.model.toStdString();
        options->extras.facts["serial_number"] = identity.serialNumber.toStdString();
    }
    options->extras.facts["written_by"] = "tiller-cli " TILLER_VERSION;
    options->recorder.format = options->format->recorder(options->extras, options->csvHead);
    recording::Recorder recorder;
    if (const auto started = recorder.start(options->recorder, receiver); !started) {
        return complain(started.error().toString(), kFailed);
    }
    ProgressLine line(!options->quiet);
    const auto end = steady_clock::now() + duration<double>(options->duration);
    const auto goesOn = [&] {
        const RecorderState state = recorder.progress().state;
        return state == RecorderState::Recording || state == RecorderState::Waiting;
    };
    while (goesOn() && (options->duration == 0 || steady_clock::now() < end) &&
           !waitForTermination(kLookEvery)) {
        line.show(describe(recorder.progress(), receiver));
    }
    recorder.stop();
    line.clear();
    const recording::RecorderProgress progress = recorder.progress();
    if (options->recorder.trigger || progress.files > 1) {
        out() << QStringLiteral("%1 files, %2 rows").arg(progress.files).arg(progress.rows) << Qt::endl;
    } else {
        out() << QStringLiteral("%1: %2 rows, %3 s, %4 lost, %5 bytes")
                     .arg(options->recorder.path)
                     .arg(progress.rows)
                     .arg(progress.seconds, 0, 'f', 3)
                     .arg(progress.lost)
                     .arg(progress.bytes)
              << Qt::endl;
    }
    if (progress.restarts > 0) {
        out() << QStringLiteral("Restarts of the controller during the recording: %1").arg(progress.restarts)
              << Qt::endl;
    }
    if (progress.state != RecorderState::Finished) {
        return complain(recorder.error().toString(), kFailed);
    }
    return kSuccess;
}

}  // namespace

const Command& recordCommand() {
    static const Command kCommand{
        .name = "record",
        .operands = "ADDRESS",
        .summary = "records the data of a robot (see 'tiller-cli record --help')",
        .title = "records the data packets of a robot",
        .usage = {"ADDRESS --out FILE [options]", "ADDRESS --out-folder FOLDER [options]"},
        .operandRows = {{"ADDRESS", "address or host name of the robot, or of a simulated robot"}},
        .options =
            {{"out", "FILE",
              QStringLiteral("output file: %1. An existing file is replaced only with --force")
                  .arg(recording::suffixHelp(FormatSet::Recorded))},
             {"out-folder", "FOLDER",
              QStringLiteral(
                  "writes a new .%1 file in this folder, named after the address and the time (UTC)")
                  .arg(newFileFormat().suffixes.constFirst())},
             {"fields", "A,B,...",
              QStringLiteral(
                  "RTDE outputs to record; the time stamp is always included. Default: for %1, all "
                  "fields that the window shows; for %2, the fields that ur_rtde records")
                  .arg(recording::suffixWords(FormatSet::Complete),
                       recording::suffixWords(FormatSet::Selected))},
             {"duration",
              "SECONDS",
              "stops this many seconds after the first packet (default: no limit). Ctrl+C or SIGTERM also "
              "stops the recording",
              "0",
              {0, 1e9}},
             {"every", "N", "records only every N-th packet (default %1)", "1", {1, 1e6}},
             {"trigger", "CONDITION",
              "records only while the condition is true, in numbered files FILE_001, "
              "FILE_002...: 'actual_TCP_force_2 > 20', 'norm(actual_TCP_force_0, actual_TCP_force_1) > 20', "
              "'robot_mode = 7', 'actual_digital_input_bits:3 = 1', 'runtime_state changes', 'program "
              "starts'. "
              "Combine conditions with 'and' and 'or'. Each file contains the conditions that were true"},
             {"before",
              "SECONDS",
              "with a trigger: also records this many seconds before the trigger (0 to 60, default %1)",
              "0",
              {0, 60}},
             {"after",
              "SECONDS",
              "with a trigger: also records this many seconds after the trigger (default %1)",
              "0",
              {0, 3600}},
             {"files", "N", "with a trigger: stops after N files", "0", {0, 1e6}},
             {"file-minutes",
              "MINUTES",
              "begins a new file after this time: FILE_001, FILE_002... No packet is lost between two files",
              "0",
              {0, 1e6}},
             {"file-size",
              "MB",
              "begins a new file when the file has this size: FILE_001, FILE_002...",
              "0",
              {0, 1e9}},
             {"attach", "FILE",
              QStringLiteral("stores a file, such as the project, inside the %1 file")
                  .arg(recording::suffixWords(FormatSet::Complete))},
             {"meta", "NAME=VALUE",
              "stores metadata in the file, such as operator=Ann or sample=7. The option can be repeated. "
              "'tiller-cli info' shows the metadata, and exports contain them"},
             {"head", "",
              "writes the start time, robot, metadata and units at the top of a .csv file, in lines that "
              "begin with # (pandas: comment='#'). --meta implies --head"},
             {"no-ros", "", "omits joint state, wrench and transform for ROS tools from the .mcap file"},
             {"keep-free",
              "MB",
              "stops the recording and completes the file when the free disk space falls below this value "
              "(default %1)",
              "200",
              {0, 1e9}},
             {"wait", "SECONDS", "time to wait for the first packet (default %1)", "10", {0, 1e6}},
             {"force", "", "replaces an existing file"},
             {"quiet", "", "shows no progress on the terminal"},
             {"port-offset", "N", "added to every port number (default %1)", "0", kPortOffsets}},
        .notes =
            "A lost connection is restored automatically, and the gap and its length are stored in the file. "
            "A restart of the controller is stored as an event with both times; 'tiller-cli info' shows the "
            "event. Data are saved every 0.5 s; a crash loses at most 0.5 s of data. Exit code: 0 the file "
            "is complete, 1 the file is incomplete or no data were received, 2 invalid arguments.",
        .run = record};
    return kCommand;
}

}  // namespace tiller::app
