// SPDX-License-Identifier: MIT
// Python module tiller._native: direct bindings of the C++ library. tiller/*.py adds the public API with
// names, arrays and docstrings.

#include <QRegularExpression>
#include <map>
#include <numeric>
#include <optional>
#include <sstream>

#include "robot/platform/thread_priority.h"
#include "robot/python/native_objects.h"
#include "robot/recording/formats/file_formats.h"
#include "robot/recording/formats/open_recording.h"
#include "robot/recording/recorder.h"

namespace tiller::python {

void raise(const Error& error) {
    const py::object type = py::module_::import("tiller.errors").attr("error_type")(toString(error.code));
    const py::object made = type(error.context.toStdString(), error.controllerMessage.toStdString());
    PyErr_SetObject(reinterpret_cast<PyObject*>(Py_TYPE(made.ptr())), made.ptr());
    throw py::error_already_set();
}

bool isInterrupted() {
    if (isParked()) {
        return true;
    }
    const py::gil_scoped_acquire locked;
    return PyErr_Occurred() != nullptr || PyErr_CheckSignals() != 0;
}

void refuseInCallback() {
    if (isInCallback()) {
        raise({ErrorCode::InvalidArgument, QStringLiteral("wait in a callback of packet_loop()"),
               QStringLiteral("the call would never return: return from the callback first")});
    }
}

void refuseOfParent(const ProcessOwned& object) {
    if (!object.isOwn()) {
        raise({ErrorCode::NotConnected, QStringLiteral("use an object created before fork()"),
               QStringLiteral("connect again in the child process")});
    }
}

namespace {

using receive::Sample;

/// Converts a sample to (sequence, host_time_ns, connection, lost_before, values).
py::tuple sampleTuple(const Sample& sample) {
    return py::make_tuple(
        sample.sequence, sample.hostTimeNs, sample.connection, sample.lostBefore,
        py::array_t<double>(static_cast<py::ssize_t>(sample.values.size()), sample.values.data()));
}

struct NativeSubscription {
    std::shared_ptr<NativeReceiver> receiver;  ///< kept alive as long as the subscription
    receive::Subscription subscription;
    Sample sample;

    py::tuple next(const Seconds& seconds) {
        refuseOfParent(*receiver);
        waited(seconds, [this](const Deadline& deadline) { return subscription.next(sample, deadline); });
        return sampleTuple(sample);
    }
    py::object tryNext() { return subscription.next(sample) ? py::object(sampleTuple(sample)) : py::none(); }
};

struct NativeRecorder : ProcessOwned {
    std::shared_ptr<NativeReceiver> receiver;
    recording::Recorder recorder;
};

recording::TableFormat tableFormat(const std::optional<std::string>& timeColumn,
                                   const std::optional<std::string>& timeUnit, double rate,
                                   const std::optional<char>& separator, const std::optional<char>& decimal,
                                   bool noHeader) {
    using recording::TimeUnit;
    recording::TableFormat format;
    format.timeColumn = timeColumn == "none" ? std::string() : timeColumn;
    if (timeUnit) {
        const std::map<std::string, TimeUnit> units{{"s", TimeUnit::Seconds},
                                                    {"ms", TimeUnit::Milliseconds},
                                                    {"us", TimeUnit::Microseconds},
                                                    {"ns", TimeUnit::Nanoseconds}};
        const auto unit = units.find(*timeUnit);
        if (unit == units.end()) {
            raise({ErrorCode::InvalidArgument, QStringLiteral("read_recording()"),
                   QStringLiteral("time_unit: must be s, ms, us or ns")});
        }
        format.timeUnit = unit->second;
    }
    format.rate = rate;
    format.separator = separator;
    format.decimal = decimal;
    format.hasHeader = noHeader ? std::optional(false) : std::nullopt;
    return format;
}

/// The error with the arguments of read_recording() instead of the options of tiller-cli, e.g.
/// time_column="none".
Result<void> withArgumentNames(Result<void> result) {
    static const QRegularExpression kOption(QStringLiteral("--([a-z]+)-([a-z]+)(?: (none)| NAME| HZ)?"));
    if (result) {
        return result;
    }
    Error error = result.error();
    QString& text = error.controllerMessage;
    qsizetype from = 0;
    for (auto match = kOption.match(text); match.hasMatch(); match = kOption.match(text, from)) {
        const QString argument = match.captured(1) + QLatin1Char('_') + match.captured(2) +
                                 (match.captured(3).isEmpty() ? QString() : QStringLiteral("=\"none\""));
        text.replace(match.capturedStart(), match.capturedLength(), argument);
        from = match.capturedStart() + argument.size();
    }
    return error;
}

/// Reads a complete recording as {column: numbers}. "seconds" is added if the time column is not `timestamp`.
py::dict readRecording(const std::string& path, const std::optional<std::string>& timeColumn,
                       const std::optional<std::string>& timeUnit, double rate,
                       const std::optional<char>& separator, const std::optional<char>& decimal,
                       bool noHeader) {
    const recording::TableFormat format =
        tableFormat(timeColumn, timeUnit, rate, separator, decimal, noHeader);
    std::unique_ptr<recording::Recording> file;
    std::vector<std::vector<double>> values;
    std::vector<double> seconds;
    const auto read = [&]() -> Result<void> {
        const GilReleased released;
        auto opened = recording::openRecording(path, format);
        if (!opened) {
            return opened.error();
        }
        file = std::move(opened).value();
        std::vector<std::size_t> all(file->columns().size());
        std::iota(all.begin(), all.end(), std::size_t{0});
        auto numbers = file->read(all, {0, file->rows()});
        if (!numbers) {
            return numbers.error();
        }
        values = std::move(numbers).value();
        auto times = file->times({0, file->rows()});
        if (!times) {
            return times.error();
        }
        seconds = std::move(times).value();
        return {};
    };
    taken(withArgumentNames(read()));
    py::dict columns;
    const auto time = file->timeColumn();
    if ((!time || file->columns()[*time].name != "timestamp") && !file->indexOf("seconds")) {
        columns["seconds"] = py::array_t<double>(static_cast<py::ssize_t>(seconds.size()), seconds.data());
    }
    for (std::size_t i = 0; i < values.size(); ++i) {
        columns[py::str(file->columns()[i].name)] =
            py::array_t<double>(static_cast<py::ssize_t>(values[i].size()), values[i].data());
    }
    return columns;
}

void defineRecorder(py::module_& module) {
    module.def(
        "format_of_content",
        [](const std::string& begin) {
            return recording::fileFormatOfContent(QByteArray::fromStdString(begin)).name.toStdString();
        },
        py::arg("begin"));
    module.def("read_recording", &readRecording, py::arg("path"), py::arg("time_column") = py::none(),
               py::arg("time_unit") = py::none(), py::arg("table_rate") = 0.0,
               py::arg("table_separator") = py::none(), py::arg("table_decimal") = py::none(),
               py::arg("no_header") = false);
    py::class_<NativeRecorder, std::unique_ptr<NativeRecorder, OwnDeleter>>(module, "Recorder")
        .def(py::init([](std::shared_ptr<NativeReceiver> receiver, const std::string& path,
                         std::vector<std::string> fields) {
                 std::unique_ptr<NativeRecorder, OwnDeleter> made(new NativeRecorder);
                 made->receiver = std::move(receiver);
                 recording::RecorderOptions options;
                 options.path = path;
                 options.format = taken(recording::formatForPath(options.path));
                 options.fields = std::move(fields);
                 taken(made->recorder.start(options, made->receiver->receiver));
                 return made;
             }),
             py::arg("receiver"), py::arg("path"), py::arg("fields"))
        .def("stop",
             [](NativeRecorder& self) {
                 if (!self.isOwn()) {
                     return;
                 }
                 {
                     const GilReleased released;
                     self.recorder.stop();
                 }
                 if (const Error error = self.recorder.error(); error.code != ErrorCode::None) {
                     raise(error);
                 }
             })
        .def("progress", [](const NativeRecorder& self) {
            const auto progress = self.recorder.progress();
            py::dict result;
            result["state"] = toString(progress.state);
            result["rows"] = progress.rows;
            result["seconds"] = progress.seconds;
            result["lost"] = progress.lost;
            result["bytes"] = progress.bytes;
            return result;
        });
}

}  // namespace

void defineReceive(py::module_& module) {
    py::class_<Clock, SharedClock>(module, "Clock").def("now_ns", &Clock::nowNs);

    py::class_<NativeSubscription>(module, "Subscription")
        .def("next", &NativeSubscription::next, py::arg("timeout"))
        .def("try_next", &NativeSubscription::tryNext)
        .def("lost", [](const NativeSubscription& self) { return self.subscription.lost(); })
        .def("pending", [](const NativeSubscription& self) { return self.subscription.pending(); });

    py::class_<NativeReceiver, std::shared_ptr<NativeReceiver>>(module, "Receiver")
        .def(py::init([](const std::string& host, int port, double frequency, std::vector<std::string> fields,
                         int priority, SharedClock clock) {
                 receive::ReceiverOptions options;
                 options.host = host;
                 options.port = static_cast<std::uint16_t>(port);
                 options.frequency = frequency;
                 if (!fields.empty()) {
                     options.fields = std::move(fields);
                 }
                 options.priority = priority;
                 return sharedOwn<NativeReceiver>(std::move(options), std::move(clock));
             }),
             py::arg("host"), py::arg("port"), py::arg("frequency"), py::arg("fields"), py::arg("priority"),
             py::arg("clock"))
        .def("start", [](NativeReceiver& self) { taken(self.receiver.start()); })
        .def(
            "stop", [](NativeReceiver& self) { self.receiver.stop(); }, py::call_guard<GilReleased>())
        .def(
            "wait_for_data",
            [](NativeReceiver& self, const Seconds& seconds) {
                return sampleTuple(waited(
                    seconds, [&](const Deadline& deadline) { return self.receiver.waitForData(deadline); }));
            },
            py::arg("timeout"))
        .def("latest", [](const NativeReceiver& self) { return sampleTuple(self.receiver.latest()); })
        .def("age",
             [](const NativeReceiver& self) { return static_cast<double>(self.receiver.ageNs()) * 1e-9; })
        .def("subscribe",
             [](std::shared_ptr<NativeReceiver> self) {
                 NativeSubscription made{self, self->receiver.subscribe(), Sample(self->receiver.layout())};
                 return made;
             })
        .def("layout",
             [](const NativeReceiver& self) {
                 py::list entries;
                 for (const auto& entry : self.receiver.layout()->entries()) {
                     entries.append(
                         py::make_tuple(entry.name, entry.first, entry.count, toString(entry.type)));
                 }
                 return entries;
             })
        .def("state", [](const NativeReceiver& self) { return toString(self.receiver.state()); })
        .def("version",
             [](const NativeReceiver& self) {
                 const auto version = self.receiver.version();
                 return py::make_tuple(version.major, version.minor, version.bugfix, version.build);
             })
        .def("period", [](const NativeReceiver& self) { return self.receiver.period(); })
        .def("absent_fields", [](const NativeReceiver& self) { return self.receiver.absentFields(); })
        .def("counters", [](const NativeReceiver& self) {
            const auto counters = self.receiver.counters();
            py::dict result;
            result["packets"] = counters.packets;
            result["late"] = counters.late;
            result["lost"] = counters.lost;
            result["reconnects"] = counters.reconnects;
            result["rate"] = counters.rateHz;
            return result;
        });
    defineRecorder(module);
}

}  // namespace tiller::python

PYBIND11_MODULE(_native, module) {
    namespace own = tiller::python;
    module.attr("__version__") = TILLER_VERSION;
    module.def("park_other_threads", &own::parkOtherThreads);
    module.def("forget_parent", &own::forgetParent);
    own::defineReceive(module);
    own::defineControl(module);
    own::defineServices(module);
    own::defineCollision(module);
    own::defineSimulator(module);
    own::defineProgram(module);
}
