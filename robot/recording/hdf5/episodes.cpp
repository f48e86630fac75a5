// SPDX-License-Identifier: MIT
#include "robot/recording/hdf5/episodes.h"

#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>
#include <cmath>
#include <iterator>

#include "robot/core/atomic_file.h"
#include "robot/recording/export.h"
#include "robot/recording/hdf5/detail/hdf5_handle.h"
#include "robot/recording/recording_format.h"

namespace tiller::recording {

namespace {

using namespace hdf5;

// Value of runtime_state. Source: RTDE guide
constexpr double kPlaying = 2;
constexpr double kResuming = 5;
constexpr std::uint64_t kRowsPerLook = 65536;

/// A matrix of rows x numbers, in row-major order.
bool putTable(hid_t group, const std::string& name, const std::vector<double>& values, std::size_t rows,
              std::size_t numbers, bool flat) {
    const hsize_t extent[2] = {rows, numbers};
    const Handle space(H5Screate_simple(flat ? 1 : 2, extent, nullptr), H5Sclose);
    const Handle set(
        H5Dcreate2(group, name.c_str(), H5T_IEEE_F64LE, space.get(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
        H5Dclose);
    return set && H5Dwrite(set.get(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) >= 0;
}

Handle makeGroup(hid_t parent, const std::string& name) {
    return {H5Gcreate2(parent, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose};
}

/// The rows of an episode, reduced to `rate` rows per second.
Result<std::vector<std::uint64_t>> thinned(const Recording& recording, RowRange range, double rate) {
    const auto times = recording.times(range);
    if (!times) {
        return times.error();
    }
    std::vector<std::uint64_t> kept;
    double due = -std::numeric_limits<double>::infinity();
    // A tolerance of half a period ensures that reducing 500 Hz to 20 Hz selects every 25th row.
    const double grace = recording.period() / 2;
    for (std::size_t i = 0; i < times.value().size(); ++i) {
        const double time = times.value()[i];
        if (rate <= 0 || time + grace >= due) {
            kept.push_back(i);
            due = rate <= 0 ? 0 : (std::isinf(due) ? time : due) + 1 / rate;
            due = std::max(due, time);
        }
    }
    return kept;
}

struct Table {
    std::vector<double> values;
    std::size_t numbers = 0;
};

/// Components of a field in the selected rows.
Result<Table> tableOf(const Recording& recording, const std::string& field, RowRange range,
                      const std::vector<std::uint64_t>& kept) {
    const auto columns = chooseColumns(recording, {field});
    if (!columns) {
        return columns.error();
    }
    const auto values = recording.read(columns.value(), range);
    if (!values) {
        return values.error();
    }
    Table table;
    table.numbers = columns.value().size();
    table.values.reserve(kept.size() * table.numbers);
    for (const std::uint64_t row : kept) {
        for (const std::vector<double>& column : values.value()) {
            table.values.push_back(column.at(static_cast<std::size_t>(row)));
        }
    }
    return table;
}

/// Shifts by one row and repeats the last row.
std::vector<double> shifted(const Table& table) {
    std::vector<double> next(table.values.begin() + static_cast<std::ptrdiff_t>(table.numbers),
                             table.values.end());
    next.insert(next.end(), table.values.end() - static_cast<std::ptrdiff_t>(table.numbers),
                table.values.end());
    return next;
}

/// Returns  the number of rows written; 0 on an HDF5 error
Result<std::uint64_t> writeDemo(hid_t data, int number, const Recording& recording, const Episode& episode,
                                const EpisodeChoice& choice) {
    const auto kept = thinned(recording, episode.rows, choice.rate);
    if (!kept) {
        return kept.error();
    }
    const std::size_t rows = kept.value().size();
    const Handle demo = makeGroup(data, "demo_" + std::to_string(number));
    const Handle now = makeGroup(demo.get(), "obs");
    const Handle next = makeGroup(demo.get(), "next_obs");
    bool ok = demo && now && next && putCount(demo.get(), "num_samples", rows) &&
              putText(demo.get(), "recording", recording.path().toStdString()) &&
              putText(demo.get(), "name", episode.name.toStdString());
    for (const std::string& field : choice.observations) {
        const auto table = tableOf(recording, field, episode.rows, kept.value());
        if (!table) {
            return table.error();
        }
        ok = ok && putTable(now.get(), field, table.value().values, rows, table.value().numbers, false) &&
             putTable(next.get(), field, shifted(table.value()), rows, table.value().numbers, false);
    }
    const auto actions = tableOf(recording, choice.action, episode.rows, kept.value());
    if (!actions) {
        return actions.error();
    }
    std::vector<double> last(rows, 0);
    last.back() = 1;
    ok = ok &&
         putTable(demo.get(), "actions", actions.value().values, rows, actions.value().numbers, false) &&
         putTable(demo.get(), "rewards", last, rows, 1, true) &&
         putTable(demo.get(), "dones", last, rows, 1, true);
    return ok ? rows : std::uint64_t(0);
}

}  // namespace

namespace {

/// Returns the operator's notes. Earlier versions of the application stored them as log lines with a
/// translated prefix.
std::vector<RecordedEvent> notesOf(const Recording& recording) {
    const std::vector<RecordedEvent>& events = recording.events();
    std::vector<RecordedEvent> notes;
    const auto copyIf = [&](const auto& isNote) {
        std::copy_if(events.begin(), events.end(), std::back_inserter(notes), isNote);
        return !notes.empty();
    };
    if (copyIf([](const RecordedEvent& event) { return event.source == QLatin1String(kNoteSource); })) {
        return notes;
    }
    const auto writer = recording.facts().find("written_by");
    const bool isFromWindow = writer != recording.facts().end() &&
                              (writer->second == "tiller" || writer->second.starts_with("tiller "));
    copyIf([&](const RecordedEvent& event) {
        static const QStringList kPrefixes{QStringLiteral("Note: "), QStringLiteral("Notiz: "),
                                           QStringLiteral("Nota: "), QStringLiteral("Note : "),
                                           QStringLiteral("メモ："), QStringLiteral("记录：")};
        return event.source == QLatin1String("operator") &&
               (!isFromWindow || std::any_of(kPrefixes.begin(), kPrefixes.end(), [&](const QString& prefix) {
                   return event.text.startsWith(prefix);
               }));
    });
    return notes;
}

}  // namespace

Result<std::vector<Episode>> findEpisodes(const Recording& recording, EpisodeChoice::Cut cut) {
    std::vector<Episode> episodes;
    if (cut == EpisodeChoice::Cut::Whole) {
        episodes.push_back({{0, recording.rows()}, QStringLiteral("whole")});
        return episodes;
    }
    if (cut == EpisodeChoice::Cut::Notes) {
        for (const RecordedEvent& event : notesOf(recording)) {
            const auto row = recording.rowAt(event.seconds);
            if (!row) {
                return row.error();
            }
            if (!episodes.empty()) {
                episodes.back().rows.count = row.value() - std::min(row.value(), episodes.back().rows.first);
            }
            episodes.push_back({{row.value(), recording.rows() - row.value()}, event.text});
        }
        return episodes;
    }
    const auto column = recording.indexOf("runtime_state");
    if (!column) {
        return Error{
            ErrorCode::FieldUnknown, QStringLiteral("find episodes in %1").arg(recording.path()),
            QStringLiteral("runtime_state, which shows when a program is running, was not recorded")};
    }
    const std::vector<std::size_t> wanted{*column};
    bool runs = false;
    for (std::uint64_t first = 0; first < recording.rows(); first += kRowsPerLook) {
        const auto values = recording.read(wanted, {first, kRowsPerLook});
        if (!values) {
            return values.error();
        }
        for (std::size_t i = 0; i < values.value().front().size(); ++i) {
            const double state = values.value().front()[i];
            const bool now = state == kPlaying || state == kResuming;
            const std::uint64_t row = first + i;
            if (now && !runs) {
                episodes.push_back({{row, recording.rows() - row}, QStringLiteral("program")});
            } else if (!now && runs) {
                episodes.back().rows.count = row - episodes.back().rows.first;
            }
            runs = now;
        }
    }
    return episodes;
}

Result<EpisodeReport> writeEpisodes(const std::vector<const Recording*>& recordings, const Text& path,
                                    const EpisodeChoice& choice) {
    const Quiet quiet;
    const QString part = path + QStringLiteral(".part");
    const auto failure = [&] {
        const bool full = errno == ENOSPC || errno == EDQUOT;
        return Error{full ? ErrorCode::DiskFull : ErrorCode::FileNotWritable, path,
                     QStringLiteral("the file cannot be written to this folder")};
    };
    const auto write = [&]() -> Result<EpisodeReport> {
        Handle file(H5Fcreate(QFile::encodeName(part).constData(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT),
                    H5Fclose);
        Handle data(file ? H5Gcreate2(file.get(), "data", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT) : -1,
                    H5Gclose);
        if (!data) {
            return failure();
        }
        EpisodeReport report;
        for (const Recording* recording : recordings) {
            const auto episodes = findEpisodes(*recording, choice.cut);
            if (!episodes) {
                return episodes.error();
            }
            for (const Episode& episode : episodes.value()) {
                const auto times = recording->times(
                    {episode.rows.first + std::max<std::uint64_t>(episode.rows.count, 1) - 1, 1});
                const auto start = recording->times({episode.rows.first, 1});
                if (!times || !start) {
                    return times ? start.error() : times.error();
                }
                if (episode.rows.count == 0 || times.value().empty() ||
                    times.value().front() - start.value().front() < choice.shortest) {
                    ++report.tooShort;
                    continue;
                }
                const auto rows = writeDemo(data.get(), report.episodes, *recording, episode, choice);
                if (!rows) {
                    return rows.error();
                }
                if (rows.value() == 0) {
                    return failure();
                }
                ++report.episodes;
                report.rows += rows.value();
            }
        }
        if (report.episodes == 0) {
            return Error{ErrorCode::InvalidArgument, QStringLiteral("write episodes to %1").arg(path),
                         QStringLiteral("these recordings contain no episodes (%1 were too short)")
                             .arg(report.tooShort)};
        }
        const QJsonObject environment{
            {"env_name", "universal-robots"}, {"type", 1}, {"env_kwargs", QJsonObject()}};
        const bool ok = putCount(data.get(), "total", report.rows) &&
                        putText(data.get(), "env_args",
                                QJsonDocument(environment).toJson(QJsonDocument::Compact).toStdString());
        if (!data.reset() || !file.reset() || !ok) {
            return failure();
        }
        return report;
    };
    const auto report = write();
    if (!report) {
        QFile::remove(part);
        return report;
    }
    const Result<void> replaced = replaceFile(part, path);
    if (!replaced) {
        QFile::remove(part);
        return replaced.error();
    }
    return report;
}

}  // namespace tiller::recording
