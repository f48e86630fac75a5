// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A recording that is too long to be read completely, with known contents in every row.

#include <QTemporaryDir>
#include <algorithm>
#include <cmath>
#include <random>

#include "robot/recording/formats/open_recording.h"
#include "robot/recording/mcap/mcap_format.h"
#include "robot/station/history/signal_store.h"
#include "tests/unit/robot/recording/made_recording.h"

namespace tiller::test {

inline constexpr std::uint64_t kRows = 700'007;  // 23 minutes; not a multiple of the block size
inline constexpr double kPeriod = 0.002;         // [s]
inline constexpr double kBegin = 50;             // start on the time axis [s]
inline constexpr std::uint64_t kGap = 123'456;
inline constexpr std::uint64_t kLost = 400;
constexpr double kSpike = 40;
inline constexpr std::uint64_t kStop = 250'000;  // first row of a protective stop
inline constexpr std::uint64_t kStopRows = 100;

/// A recording with few signals, with spikes at random rows and one gap.
struct Long {
    QTemporaryDir folder;
    QString path = folder.filePath("long.mcap");
    std::vector<float> force;           ///< indexed by row
    std::vector<std::uint64_t> spikes;  ///< row numbers
    std::uint64_t gap;                  ///< first row after the gap

    explicit Long(std::uint64_t rows = kRows, std::uint64_t firstAfterGap = kGap, bool noteInGap = false)
        : gap(firstAfterGap) {
        test::MadeSamples made({"timestamp", "actual_TCP_force", "robot_mode", "safety_mode"});
        const std::size_t fz = *made.layout->indexOfComponent("actual_TCP_force_2");
        const std::size_t clock = *made.layout->indexOfComponent("timestamp");
        const std::size_t mode = *made.layout->indexOfComponent("robot_mode");
        const std::size_t safety = *made.layout->indexOfComponent("safety_mode");
        const auto encoder =
            recording::mcapFormat({.ros = false, .closeAfter = std::chrono::milliseconds(0)})
                ->encoder(
                    {made.layout, {"timestamp", "actual_TCP_force", "robot_mode", "safety_mode"}, false});
        std::mt19937 random(19);
        std::uniform_int_distribution<std::uint64_t> place(0, rows - 1);
        for (int i = 0; i < 60; ++i) {
            spikes.push_back(place(random));
        }
        std::sort(spikes.begin(), spikes.end());
        QFile file(path);
        if (!file.open(QIODevice::WriteOnly)) {
            qFatal("cannot write");
        }
        std::uint64_t packet = 0;
        for (std::uint64_t row = 0; row < rows; ++row, ++packet) {
            packet += row == gap ? kLost : 0;
            receive::Sample sample = made.at(packet);
            sample.values[clock] = static_cast<double>(packet) * kPeriod;
            const bool isSpike = std::binary_search(spikes.begin(), spikes.end(), row);
            sample.values[fz] =
                isSpike ? (row % 2 == 0 ? kSpike : -kSpike) : std::sin(static_cast<double>(row) * 1e-3);
            sample.values[mode] = row < rows / 2 ? 7 : 5;
            sample.values[safety] = row >= kStop && row < kStop + kStopRows ? 3 : 1;
            force.push_back(static_cast<float>(sample.values[fz]));
            if (noteInGap && row == gap) {
                encoder->add({made.utcNs(packet - kLost / 2), 30, "tiller", "Waiting for data"});
            }
            encoder->add(sample, row == gap ? kLost : 0, made.utcNs(packet));
            if (row % 250 == 249) {
                file.write(QByteArray::fromStdString(
                    encoder->take(recording::RecordingEncoder::Close::WhenDue).bytes));
            }
        }
        file.write(QByteArray::fromStdString(encoder->take(recording::RecordingEncoder::Close::Last).bytes));
    }
    double timeOf(std::uint64_t row) const {
        return kBegin + static_cast<double>(row + (row < gap ? 0 : kLost)) * kPeriod;
    }
};

struct Opened {
    SignalStore store;
    QString name;
    int signal = -1;
    int mode = -1;

    explicit Opened(const QString& path) {
        auto file = recording::openRecording(path);
        name = store.open(std::move(file).value(), kBegin).value();
        signal = store.find(name + QStringLiteral("/actual_TCP_force_2"));
        mode = store.find(name + QStringLiteral("/robot_mode"));
    }
    const SeriesBuffer& history() const { return *store.buffer(signal); }
};

}  // namespace tiller::test
