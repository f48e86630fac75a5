// SPDX-License-Identifier: MIT
#include "robot/recording/mcap/black_box.h"

#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QTimeZone>
#include <algorithm>
#include <array>
#include <atomic>
#include <charconv>
#include <cmath>
#include <deque>
#include <optional>
#include <vector>

#include "robot/core/atomic_file.h"
#include "robot/core/modes.h"
#include "robot/publish/publisher.h"
#include "robot/receive/robot_state.h"
#include "robot/recording/detail/packet_clock.h"
#include "robot/recording/detail/recording_file.h"
#include "robot/recording/incident.h"
#include "robot/recording/mcap/detail/extra_samples.h"
#include "robot/recording/mcap/detail/sample_store.h"
#include "robot/recording/mcap/mcap_format.h"

namespace tiller::recording {

namespace {

constexpr double kShortest = 1;
constexpr double kMaxTimeBefore = 600;
constexpr double kMaxTimeAfter = 60;
constexpr std::size_t kMaxNotes = 10'000;

/// Name of this type of stop in file names; null if the mode is not a stop.
const char* reasonOf(SafetyMode mode) {
    switch (mode) {
        case SafetyMode::ProtectiveStop:
            return "protective-stop";
        case SafetyMode::SystemEmergencyStop:
        case SafetyMode::RobotEmergencyStop:
        case SafetyMode::ImmiEmergencyStop:
        case SafetyMode::ProfisafeEmergencyStop:
            return "emergency-stop";
        case SafetyMode::Violation:
            return "violation";
        case SafetyMode::Fault:
            return "fault";
        default:
            return nullptr;
    }
}

/// The shortest text that converts back exactly.
std::string shortestText(double value) {
    std::array<char, 32> text{};
    const auto [end, failed] = std::to_chars(text.data(), text.data() + text.size(), value);
    return failed == std::errc() ? std::string(text.data(), end) : std::string();
}

std::string asName(const QString& reason) {
    std::string name;
    for (const QChar c : reason.toLower().left(40)) {
        const bool plain = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
        name += plain ? static_cast<char>(c.unicode()) : '-';
    }
    return name.empty() ? "alarm" : name;
}

}  // namespace

struct BlackBox::Worker : publish::SampleSink {
    BlackBoxOptions options;
    std::shared_ptr<const receive::SampleLayout> layout;
    PacketClock clock;

    mutable std::mutex mutex;  // protects the following members
    std::deque<RecordedNote> notes;
    std::optional<std::string> alarm;
    std::vector<receive::Subscription> nextExtra;
    std::string projectName;
    std::string project;
    std::map<std::string, std::string> facts;
    std::atomic<std::uint64_t> packets{0};

    // Only the threads of the publisher use the following members.
    std::optional<SampleStore> store;
    std::optional<ExtraSamples> extra;
    std::optional<SafetyMode> previous;
    std::uint64_t lastConnection = 0;
    std::optional<Incident> pending;
    bool isDue = false;                 ///< the pending incident is complete and must be written
    std::optional<std::string> raised;  ///< alarm to be processed in this turn of the publisher
    std::int64_t stopNs = 0;            ///< time of the stop on the receiver's clock
    double stopTimestamp = 0;           ///< time of the stop on the controller's clock [s]

    /// The turn may allocate the memory for a minute of samples, or write a file.
    bool mayBlock() const override {
        const std::lock_guard lock(mutex);
        return !store || pending || alarm;
    }

    void beginTurn() override {
        if (!store) {
            constexpr double kMaxRateHz = 500;
            const double seconds = options.before + options.after + 2;
            const auto capacity = static_cast<std::size_t>(seconds * kMaxRateHz);
            store.emplace(capacity, layout);
            extra.emplace(capacity);
        }
        if (std::exchange(isDue, false)) {
            write();
        }
        const std::lock_guard lock(mutex);
        raised = std::exchange(alarm, std::nullopt);
    }

    Next take(const receive::Sample& sample, std::uint64_t missing) override {
        const SafetyMode now = receive::RobotState(sample).safetyMode();
        // A stop that is already active when connecting happened earlier.
        const bool wasPending = pending.has_value();
        const bool isNew = previous && sample.connection == lastConnection && *previous != now;
        lastConnection = sample.connection;
        previous = now;
        if (isNew && !pending && reasonOf(now) != nullptr) {
            begin(reasonOf(now), sample);
        }
        store->next() = sample;
        store->keepNext(missing);
        ++packets;
        forgetBefore(sample.hostTimeNs);
        isDue = pending && static_cast<double>(sample.hostTimeNs - stopNs) >= options.after * 1e9;
        // A turn that may write the file must be announced by mayBlock().
        return isDue || (pending && !wasPending) ? Next::NewTurn : Next::Continue;
    }

    bool endTurn(bool last) override {
        drainExtra();
        if (raised && !pending && store->count() > 0) {
            begin(raised->c_str(), store->at(store->count() - 1));
        }
        raised.reset();
        if (pending && last) {
            write();
        }
        return !last;
    }

    void drainExtra() {
        std::vector<receive::Subscription> next;
        {
            const std::lock_guard lock(mutex);
            next.swap(nextExtra);
        }
        for (receive::Subscription& each : next) {
            extra->follow(std::move(each));
        }
        extra->drain();
    }

    void forgetBefore(std::int64_t nowNs) {
        const std::int64_t from =
            (pending ? stopNs : nowNs) - static_cast<std::int64_t>(std::llround(options.before * 1e9));
        while (store->count() > 0 && store->at(0).hostTimeNs < from) {
            store->dropOldest();
        }
        extra->forgetBefore(from);
    }

    void begin(const char* reason, const receive::Sample& sample) {
        stopNs = sample.hostTimeNs;
        stopTimestamp = receive::RobotState(sample).timestamp();
        pending.emplace();
        pending->reason = reason;
        pending->utcNs = clock.utcOf(stopNs);
    }

    void write() {
        drainExtra();
        Incident incident = std::exchange(pending, std::nullopt).value();
        const auto result = writeFile(incident);
        if (!result) {
            incident.error = result.error();
            incident.path = {};
        } else {
            removeOldest();
        }
        if (options.written) {
            options.written(incident);
        }
    }

    QString freePath(const Incident& incident) const {
        constexpr std::int64_t kNsPerMs = 1'000'000;
        const QDateTime time = QDateTime::fromMSecsSinceEpoch(incident.utcNs / kNsPerMs);
        const QString name =
            QStringLiteral("incident_%1_%2")
                .arg(time.toString(QStringLiteral("yyyy-MM-dd_HH-mm-ss")), Text(incident.reason));
        const QDir folder(options.folder);
        QString path = folder.filePath(name + QStringLiteral(".mcap"));
        for (int more = 2; QFileInfo::exists(path); ++more) {
            path = folder.filePath(QStringLiteral("%1_%2.mcap").arg(name).arg(more));
        }
        return path;
    }

    Result<void> writeFile(Incident& incident) {
        if (!QDir().mkpath(options.folder)) {
            return Error{ErrorCode::FileNotWritable, options.folder,
                         QStringLiteral("the folder cannot be created")};
        }
        incident.path = freePath(incident);
        McapFormatOptions format;
        format.facts = options.facts;
        format.facts[kIncidentFact] = incident.reason;
        format.facts[kIncidentUtcFact] = std::to_string(incident.utcNs);
        if (std::isfinite(stopTimestamp)) {
            format.facts[kIncidentTimeFact] = shortestText(stopTimestamp);
        }
        std::deque<RecordedNote> said;
        {
            const std::lock_guard lock(mutex);
            format.attachmentName = projectName;
            format.attachment = project;
            for (const auto& [key, value] : facts) {
                format.facts[key] = value;
            }
            said = notes;
        }
        RowJoiner rows(layout, extra->samples());
        const auto allFields = rows.layout();
        std::vector<std::string> fields;
        for (const auto& entry : allFields->entries()) {
            fields.push_back(entry.name);
        }
        const auto encoder = mcapFormat(format)->encoder({allFields, fields, false});
        auto file = systemFile();
        // The file has a temporary name until it is complete.
        const QString part = incident.path + QStringLiteral(".part");
        if (auto opened = file->open(part); !opened) {
            return opened;
        }
        incident.secondsBefore =
            store->count() == 0 ? 0 : static_cast<double>(stopNs - store->at(0).hostTimeNs) / 1e9;
        for (std::size_t i = 0; i < store->count(); ++i) {
            encoder->add(rows.join(store->at(i)), i == 0 ? 0 : store->missingBefore(i),
                         clock.utcOf(store->at(i).hostTimeNs));
        }
        const std::int64_t from = store->count() == 0 ? 0 : clock.utcOf(store->at(0).hostTimeNs);
        for (const RecordedNote& note : said) {
            if (note.utcNs >= from) {
                encoder->add(note);
            }
        }
        encoder->add({incident.utcNs, 40, "tiller", Text("incident: " + incident.reason)});
        const std::string bytes = encoder->take(RecordingEncoder::Close::Last).bytes;
        std::size_t got = 0;
        Result<void> result = file->write(bytes, got);
        if (result) {
            result = file->sync();
        }
        if (auto closed = file->close(); result && !closed) {
            result = closed;
        }
        if (result) {
            result = replaceFile(part, incident.path);
        }
        if (!result) {
            QFile::remove(part);
        }
        return result;
    }

    void removeOldest() {
        const QDir folder(options.folder);
        // The file names start with the time, so the oldest file is first.
        const QStringList files =
            folder.entryList({QStringLiteral("incident_*.mcap")}, QDir::Files, QDir::Name);
        for (qsizetype i = 0; i < files.size() - options.keep; ++i) {
            QFile::remove(folder.filePath(files[i]));
        }
    }

    std::shared_ptr<publish::Publisher> publisher;
    publish::Publication publication;
};

BlackBox::BlackBox() = default;

BlackBox::BlackBox(std::shared_ptr<publish::Publisher> publisher) : publisher_(std::move(publisher)) {}

BlackBox::~BlackBox() {
    stop();
}

std::shared_ptr<BlackBox::Worker> BlackBox::worker() const {
    const std::lock_guard lock(mutex_);
    return d_;
}

Result<void> BlackBox::start(const BlackBoxOptions& options, const receive::Receiver& receiver) {
    stop();
    if (options.folder.isEmpty()) {
        return Error{ErrorCode::InvalidArgument, QStringLiteral("start the black box"),
                     QStringLiteral("no folder is specified")};
    }
    auto next = std::make_shared<Worker>();
    next->options = options;
    next->options.before = std::clamp(options.before, kShortest, kMaxTimeBefore);
    next->options.after = std::clamp(options.after, 0.0, kMaxTimeAfter);
    next->options.keep = std::max(options.keep, 1);
    next->layout = receiver.layout();
    next->publisher =
        publisher_ ? publisher_ : std::make_shared<publish::Publisher>(publish::Publisher::Sinks::One);
    next->publication = next->publisher->add({next, receiver.subscribe(), receiver.layout()}).value();
    const std::lock_guard lock(mutex_);
    d_ = std::move(next);
    return {};
}

void BlackBox::stop() {
    std::shared_ptr<Worker> ending;
    {
        const std::lock_guard lock(mutex_);
        ending.swap(d_);
    }
    if (ending) {
        ending->publication.stop();
        ending->publisher.reset();
    }
}

void BlackBox::followExtra(receive::Subscription extra) {
    if (const auto box = worker()) {
        const std::lock_guard lock(box->mutex);
        box->nextExtra.push_back(std::move(extra));
    }
}

void BlackBox::note(const RecordedNote& note) {
    if (const auto box = worker()) {
        const std::lock_guard lock(box->mutex);
        box->notes.push_back(note);
        box->notes.back().utcNs = box->clock.utcOfNote(note.utcNs);
        if (box->notes.size() > kMaxNotes) {
            box->notes.pop_front();
        }
    }
}

void BlackBox::alarm(const Text& reason) {
    if (const auto box = worker()) {
        const std::lock_guard lock(box->mutex);
        box->alarm = asName(reason);
    }
}

void BlackBox::setProject(const Text& name, std::string content) {
    if (const auto box = worker()) {
        const std::lock_guard lock(box->mutex);
        box->projectName = name.toStdString();
        box->project = std::move(content);
    }
}

std::uint64_t BlackBox::packets() const {
    const auto box = worker();
    return box ? box->packets.load() : 0;
}

void BlackBox::setFact(const std::string& key, const std::string& value) {
    if (const auto box = worker()) {
        const std::lock_guard lock(box->mutex);
        box->facts[key] = value;
    }
}

}  // namespace tiller::recording
