// SPDX-License-Identifier: MIT
#pragma once

// Samples of a simulated robot, and files written from them, without a socket or thread.

#include <QFile>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "robot/receive/receiver.h"
#include "robot/recording/recording_format.h"

namespace tiller::test {

/// 2026-01-01 00:00:00 UTC
inline constexpr std::int64_t kMadeStartNs = 1'767'225'600'000'000'000;

/// Consecutive packages of an oscillating robot. Every value is known.
class MadeSamples {
public:
    explicit MadeSamples(std::vector<std::string> fields = receive::defaultFields())
        : layout(std::make_shared<receive::SampleLayout>(fields)), sample_(layout) {}

    /// Sample of the row, counted from 0.
    const receive::Sample& at(std::uint64_t row) {
        sample_.sequence = row + 1;
        sample_.hostTimeNs = static_cast<std::int64_t>(row) * 2'000'000 + 1'000'000'000;
        sample_.connection = 1;
        for (std::size_t i = 0; i < sample_.values.size(); ++i) {
            sample_.values[i] = value(i, row);
        }
        return sample_;
    }
    double value(std::size_t component, std::uint64_t row) const {
        const double time = static_cast<double>(row) * 0.002;
        if (layout->componentNames()[component] == "timestamp") {
            return 100 + time;
        }
        for (const auto& entry : layout->entries()) {
            if (component >= entry.first && component < entry.first + entry.count) {
                const bool real = entry.type == rtde::DataType::Double ||
                                  entry.type == rtde::DataType::Vector3D ||
                                  entry.type == rtde::DataType::Vector6D;
                return real ? std::sin(time + static_cast<double>(component))
                            : static_cast<double>((row / 100 + component) % 2);
            }
        }
        return 0;
    }
    std::int64_t utcNs(std::uint64_t row) const {
        return kMadeStartNs + static_cast<std::int64_t>(row) * 2'000'000;
    }

    std::shared_ptr<const receive::SampleLayout> layout;

private:
    receive::Sample sample_;
};

/// Returns a complete file with `rows` rows and a note at half of them. Unless `gap` is 0, row `gap` follows
/// 5 lost packages.
inline std::string madeFile(const recording::RecordingFormat& format, std::uint64_t rows,
                            std::uint64_t gap = 0) {
    MadeSamples samples;
    std::vector<std::string> fields;
    for (const auto& entry : samples.layout->entries()) {
        fields.push_back(entry.name);
    }
    const auto encoder = format.encoder({samples.layout, fields, false});
    std::string file;
    for (std::uint64_t row = 0; row < rows; ++row) {
        encoder->add(samples.at(row), gap != 0 && row == gap ? 5 : 0, samples.utcNs(row));
        if (row == rows / 2) {
            encoder->add({samples.utcNs(row), 30, "operator", "half way"});
        }
    }
    file += encoder->take(recording::RecordingEncoder::Close::Last).bytes;
    return file;
}

inline bool writeFile(const QString& path, const std::string& bytes) {
    QFile file(path);
    return file.open(QIODevice::WriteOnly | QIODevice::Truncate) &&
           file.write(bytes.data(), static_cast<qint64>(bytes.size())) == static_cast<qint64>(bytes.size());
}

}  // namespace tiller::test
