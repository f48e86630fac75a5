// SPDX-License-Identifier: MIT
//
// Measures the speed of writing, opening and exporting recordings per second of processor time, from memory
// to a folder (default: a temporary folder). Prints a table. Does not check limits.
//   recording_speed [minutes] [folder]

#include <QCoreApplication>
#include <QFileInfo>
#include <QTemporaryDir>
#include <cstdio>
#include <ctime>
#include <functional>
#include <numeric>

#include "robot/recording/formats/open_recording.h"
#include "robot/recording/hdf5/hdf5_export.h"
#include "robot/recording/mcap/mcap_format.h"
#include "tests/unit/robot/recording/made_recording.h"

using namespace tiller;
using namespace tiller::recording;

namespace {

/// Returns processor time, so that other processes have no effect.
double secondsOf(const std::function<void()>& work) {
    const std::clock_t begin = std::clock();
    work();
    return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

void print(const char* what, double bytes, double seconds) {
    std::printf("%-44s %9.1f MB %8.3f s %9.1f MB/s\n", what, bytes / 1e6, seconds, bytes / 1e6 / seconds);
    std::fflush(stdout);
}

/// Returns samples with sensor-like noise. They are repeated, so that generating them costs no time.
std::vector<receive::Sample> someSamples(test::MadeSamples& made) {
    std::vector<receive::Sample> samples;
    std::uint64_t state = 1;
    for (std::uint64_t row = 0; row < 1000; ++row) {
        samples.push_back(made.at(row));
        for (const auto& entry : made.layout->entries()) {
            for (std::size_t i = 0; i < entry.count && entry.type == rtde::DataType::Vector6D; ++i) {
                state = state * 6364136223846793005u + 1442695040888963407u;
                samples.back().values[entry.first + i] += static_cast<double>(state >> 40) * 1e-12;
            }
        }
    }
    return samples;
}

std::int64_t record(const RecordingFormat& format, const QString& path, std::uint64_t rows) {
    test::MadeSamples made;
    auto samples = someSamples(made);
    std::vector<std::string> fields;
    for (const auto& entry : made.layout->entries()) {
        fields.push_back(entry.name);
    }
    const auto encoder = format.encoder({made.layout, fields, false});
    QFile file(path);
    file.open(QIODevice::WriteOnly | QIODevice::Truncate | QIODevice::Unbuffered);
    const auto put = [&](const std::string& bytes) {
        file.write(bytes.data(), static_cast<qint64>(bytes.size()));
    };
    for (std::uint64_t row = 0; row < rows; ++row) {
        receive::Sample& sample = samples[row % samples.size()];
        sample.sequence = row + 1;
        encoder->add(sample, 0, made.utcNs(row));
        if (row % 250 == 249) {
            put(encoder->take(RecordingEncoder::Close::WhenDue).bytes);
        }
    }
    put(encoder->take(RecordingEncoder::Close::Last).bytes);
    file.close();
    return QFileInfo(path).size();
}

}  // namespace

int main(int argc, char** argv) {
    QCoreApplication app(argc, argv);
    const double minutes = argc > 1 ? std::atof(argv[1]) : 2;
    const QTemporaryDir temporary;
    const QString folder = argc > 2 ? QString::fromLocal8Bit(argv[2]) : temporary.path();
    const auto rows = static_cast<std::uint64_t>(minutes * 60 * 500);
    const QString mcap = folder + "/a.mcap";
    const QString flat = folder + "/flat.mcap";
    const QString csv = folder + "/a.csv";
    const QString hdf5 = folder + "/a.h5";

    const test::MadeSamples made;
    const double numbers = static_cast<double>(rows * made.layout->size());
    const double raw = numbers * sizeof(double);
    std::printf("%llu rows of %zu numbers, %.1f minutes at 500 Hz\n", static_cast<unsigned long long>(rows),
                made.layout->size(), minutes);
    std::int64_t size = 0;
    print("write MCAP, with ROS messages (numbers in)", raw, secondsOf([&] {
              size = record(*mcapFormat({.closeAfter = std::chrono::milliseconds(0)}), mcap, rows);
          }));
    std::printf("%-44s %9.1f MB, %.2f of the numbers\n", "  its size", static_cast<double>(size) / 1e6,
                static_cast<double>(size) / raw);
    print("write MCAP, the flat message alone", raw, secondsOf([&] {
              size =
                  record(*mcapFormat({.ros = false, .closeAfter = std::chrono::milliseconds(0)}), flat, rows);
          }));
    std::printf("%-44s %9.1f MB, %.2f of the numbers\n", "  its size", static_cast<double>(size) / 1e6,
                static_cast<double>(size) / raw);

    std::unique_ptr<Recording> recording;
    std::printf("%-44s %21.3f s\n", "open MCAP", secondsOf([&] { recording = openRecording(mcap).value(); }));
    std::vector<std::size_t> curves(std::min<std::size_t>(24, recording->columns().size()));
    std::iota(curves.begin(), curves.end(), std::size_t(0));
    std::printf("%-44s %21.3f s\n", "  first picture, 24 curves, 1920 columns", secondsOf([&] {
                    recording->summaries(curves, {0, recording->rows()}, 1920).value();
                }));
    std::printf("%-44s %21.3f s\n", "  a tenth of it", secondsOf([&] {
                    recording->summaries(curves, {rows / 2, rows / 10}, 1920).value();
                }));
    std::printf("%-44s %21.3f s\n", "  4000 rows as they are", secondsOf([&] {
                    recording->read(curves, {rows / 2, 4000}).value();
                }));

    ExportReport report;
    double seconds = secondsOf([&] { report = exportCsv(*recording, {.path = csv}).value(); });
    print("export CSV (text out)", static_cast<double>(report.bytes), seconds);
    seconds = secondsOf([&] { report = exportHdf5(*recording, {.path = hdf5}).value(); });
    print("export HDF5 (file out)", static_cast<double>(report.bytes), seconds);
    print("read CSV (text in)", static_cast<double>(QFileInfo(csv).size()),
          secondsOf([&] { recording = openRecording(csv).value(); }));
    std::vector<std::size_t> all(recording->columns().size());
    std::iota(all.begin(), all.end(), std::size_t(0));
    seconds = secondsOf([&] { report = exportCsv(*recording, {.path = csv + "2"}).value(); });
    print("export CSV from memory (text out)", static_cast<double>(report.bytes), seconds);
    return 0;
}
