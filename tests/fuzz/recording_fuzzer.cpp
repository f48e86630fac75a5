// SPDX-License-Identifier: MIT
//
// Reads arbitrary bytes as a recording, either MCAP or text. Opening the recording, reading the declared
// content, and comparing it with the model of an arm must end in a short time. HDF5 files are not covered,
// because libhdf5 parses them.

#include <QFile>
#include <QTemporaryDir>
#include <cstdint>

#include "robot/divergence/divergence.h"
#include "robot/recording/csv_recording.h"
#include "robot/recording/mcap/mcap_recording.h"

using namespace tiller;

namespace {

void readAll(const recording::Recording& recording) {
    constexpr std::uint64_t kMaxRows = 10'000;
    constexpr std::size_t kMaxColumns = 20;
    std::vector<std::size_t> columns;
    for (std::size_t i = 0; i < std::min(recording.columns().size(), kMaxColumns); ++i) {
        columns.push_back(i);
    }
    static_cast<void>(recording.read(columns, {0, kMaxRows}));
    static_cast<void>(recording.times({0, kMaxRows}));
    static_cast<void>(recording.summaries(columns, {0, kMaxRows}, 7));
    static_cast<void>(recording.rowAt(0.5));
    for (const QString& name : recording.attachments()) {
        static_cast<void>(recording.attachment(name));
    }
    divergence::Choice choice;
    choice.model = RobotModelId::UR5e;
    choice.until = 5;
    static_cast<void>(divergence::compare(recording, choice));
}

/// One of the formats that a user can select.
recording::TableFormat formatOf(std::uint8_t choice) {
    recording::TableFormat format;
    if ((choice & 1) != 0) {
        format.timeColumn = (choice & 2) != 0 ? "" : "t";
    }
    if ((choice & 4) != 0) {
        format.timeUnit = recording::TimeUnit::Milliseconds;
    }
    if ((choice & 8) != 0) {
        format.separator = (choice & 16) != 0 ? ' ' : ';';
    }
    if ((choice & 32) != 0) {
        format.decimal = ',';
    }
    if ((choice & 64) != 0) {
        format.hasHeader = false;
    }
    format.rate = (choice & 128) != 0 ? 100 : 0;
    return format;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const QTemporaryDir folder;
    static const QString path = folder.filePath("a");
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly | QIODevice::Truncate)) {
        return 0;
    }
    file.write(reinterpret_cast<const char*>(data), static_cast<qint64>(size));
    file.close();
    if (auto recording = recording::openMcap(path)) {
        readAll(*recording.value());
        return 0;
    }
    // The last byte selects the format.
    for (const recording::TableFormat& format :
         {recording::TableFormat{}, formatOf(size > 0 ? data[size - 1] : 0)}) {
        if (auto text = recording::openCsv(path, format)) {
            readAll(*text.value());
        }
    }
    return 0;
}
