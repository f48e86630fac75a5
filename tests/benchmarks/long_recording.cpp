// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measures the time to open a long recording: the first complete image of 24 curves from a file with 150
// values per packet, and then any range of the file. The file is created in the format of the recorder and
// deleted afterwards. Prints processor time and wall time. Does not check limits.
//
// long_recording [--hours H] [--folder F] [--zooms N] [--keep]
//   --hours   duration of the recording; default 0.5. Eight hours need 10 GB of disk space, and creating the
//             file takes minutes
//   --folder  folder of the file; an existing long.mcap with this duration is reused

#include <QApplication>
#include <QDir>
#include <QElapsedTimer>
#include <QFileInfo>
#include <QImage>
#include <QPainter>
#include <QTemporaryDir>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <functional>
#include <random>

#include "robot/recording/formats/open_recording.h"
#include "robot/recording/mcap/mcap_format.h"
#include "robot/station/history/plot_marks.h"
#include "robot/station/history/signal_store.h"
#include "robot/station/history/state_lane.h"
#include "tests/unit/robot/recording/made_recording.h"
#include "widgets/common/theme.h"
#include "widgets/plots/plot_view.h"

using namespace tiller;

namespace {

constexpr double kRate = 500;  // [Hz]
constexpr std::size_t kNumbers = 150;

struct Time {
    double cpu = 0;   // [s]
    double wall = 0;  // [s]
};

Time timeOf(const std::function<void()>& work) {
    QElapsedTimer wall;
    wall.start();
    const std::clock_t begin = std::clock();
    work();
    return {static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC,
            static_cast<double>(wall.nsecsElapsed()) * 1e-9};
}

/// Returns fields with kNumbers values or slightly more.
std::vector<std::string> someFields() {
    std::vector<std::string> fields;
    std::size_t numbers = 0;
    for (const std::string& field : receive::defaultFields()) {
        if (numbers < kNumbers) {
            fields.push_back(field);
            numbers += receive::SampleLayout({field}).size();
        }
    }
    return fields;
}

/// Writes a recording that repeats a thousand packets, with increasing time, sensor-like noise and occasional
/// spikes.
bool make(const QString& path, std::uint64_t rows) {
    const std::vector<std::string> fields = someFields();
    test::MadeSamples made(fields);
    std::vector<receive::Sample> samples;
    std::mt19937_64 random(19);
    std::uniform_real_distribution<double> noise(-1e-3, 1e-3);
    for (std::uint64_t row = 0; row < 1000; ++row) {
        samples.push_back(made.at(row));
        for (const auto& entry : made.layout->entries()) {
            for (std::size_t i = 0; i < entry.count && entry.type == rtde::DataType::Vector6D; ++i) {
                double& value = samples.back().values[entry.first + i];
                value = std::round((value + noise(random)) * 1e7) / 1e7;
            }
        }
    }
    const std::size_t clock = *made.layout->indexOfComponent("timestamp");
    const auto encoder = recording::mcapFormat({.ros = false, .closeAfter = std::chrono::milliseconds(0)})
                             ->encoder({made.layout, fields, false});
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly | QIODevice::Truncate | QIODevice::Unbuffered)) {
        return false;
    }
    const auto put = [&file](const std::string& bytes) {
        return file.write(bytes.data(), static_cast<qint64>(bytes.size())) ==
               static_cast<qint64>(bytes.size());
    };
    bool good = true;
    for (std::uint64_t row = 0; row < rows && good; ++row) {
        receive::Sample& sample = samples[row % samples.size()];
        sample.sequence = row + 1;
        sample.values[clock] = 100 + static_cast<double>(row) / kRate;
        encoder->add(sample, 0, made.utcNs(row));
        if (row % 250 == 249) {
            good = put(encoder->take(recording::RecordingEncoder::Close::WhenDue).bytes);
        }
    }
    return good && put(encoder->take(recording::RecordingEncoder::Close::Last).bytes);
}

PageLayout pageOf(const SignalStore& store, const QString& recording) {
    PageLayout page;
    for (const char* field : {"actual_q", "actual_qd", "actual_current", "target_q"}) {
        QStringList keys;
        for (int i = 0; i < 6; ++i) {
            keys << QStringLiteral("%1/%2_%3").arg(recording, QLatin1String(field)).arg(i);
        }
        page.panes.append({keys, {}, 0, 1});
    }
    for (const PaneLayout& pane : page.panes) {
        for (const QString& key : pane.shown) {
            if (store.find(key) < 0) {
                std::fprintf(stderr, "there is no %s\n", qPrintable(key));
            }
        }
    }
    return page;
}

void print(const char* what, std::vector<Time> times) {
    std::sort(times.begin(), times.end(), [](const Time& a, const Time& b) { return a.cpu < b.cpu; });
    const Time& middle = times[times.size() / 2];
    const double slowest = std::max_element(times.begin(), times.end(), [](const Time& a, const Time& b) {
                               return a.wall < b.wall;
                           })->wall;
    std::printf("%-44s CPU median %7.1f most %7.1f | wall median %7.1f most %7.1f ms\n", what,
                middle.cpu * 1e3, times.back().cpu * 1e3, middle.wall * 1e3, slowest * 1e3);
}

}  // namespace

int main(int argc, char** argv) {
    double hours = 0.5;
    int zooms = 60;
    bool keep = false;
    const QTemporaryDir temporary;
    QString folder = temporary.path();
    for (int i = 1; i < argc; ++i) {
        const bool more = i + 1 < argc;
        if (std::strcmp(argv[i], "--keep") == 0) {
            keep = true;
        } else if (more && std::strcmp(argv[i], "--hours") == 0) {
            hours = std::clamp(std::atof(argv[++i]), 0.05, 24.0);
        } else if (more && std::strcmp(argv[i], "--folder") == 0) {
            folder = QString::fromLocal8Bit(argv[++i]);
        } else if (more && std::strcmp(argv[i], "--zooms") == 0) {
            zooms = std::max(10, std::atoi(argv[++i]));
        } else {
            std::fprintf(stderr, "long_recording [--hours H] [--folder F] [--zooms N] [--keep]\n");
            return 2;
        }
    }
    if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) {
        qputenv("QT_QPA_PLATFORM", "offscreen");
    }
    QApplication application(argc, argv);
    applyTheme(application, Theme::light());

    const QString path = QDir(folder).filePath("long.mcap");
    const auto rows = static_cast<std::uint64_t>(hours * 3600 * kRate);
    if (!QFileInfo::exists(path)) {
        bool made = false;
        const Time took = timeOf([&] { made = make(path, rows); });
        if (!made) {
            std::fprintf(stderr, "%s cannot be written\n", qPrintable(path));
            QFile::remove(path);
            return 1;
        }
        std::printf("made in %.0f s of processor time\n", took.cpu);
    }
    std::printf("%llu rows of %zu numbers: %.2f GB as float32, the file %.2f GB\n",
                static_cast<unsigned long long>(rows), receive::SampleLayout(someFields()).size(),
                static_cast<double>(rows * receive::SampleLayout(someFields()).size()) * 4e-9,
                static_cast<double>(QFileInfo(path).size()) * 1e-9);

    int status = 0;
    {
        SignalStore store(HistoryLimits{1800, std::size_t{1} << 30});
        const StateLane lane;
        PlotMarks marks(store);
        PlotView view(store, lane, marks);
        view.setAttribute(Qt::WA_DontShowOnScreen);
        view.resize(1920 + 66, 900);
        view.setVisible(true);
        QCoreApplication::processEvents();
        QImage image(view.size(), QImage::Format_RGB32);
        const auto draw = [&] {
            QPainter painter(&image);
            view.render(&painter);
        };
        const double all = static_cast<double>(rows) / kRate;
        const Time opening = timeOf([&] {
            auto file = recording::openRecording(path);
            if (file) {
                const auto name = store.open(std::move(file).value(), 0);
                status = name && view.setPage(pageOf(store, *name)) ? 0 : 1;
            } else {
                status = 1;
            }
        });
        const Time first = timeOf([&] {
            view.showRange(0, all);
            draw();
        });
        std::printf("%-44s CPU %7.3f wall %7.3f s\n", "opening, 24 curves chosen", opening.cpu, opening.wall);
        std::printf("%-44s CPU %7.3f wall %7.3f s\n", "first whole picture, opening included",
                    opening.cpu + first.cpu, opening.wall + first.wall);
        std::mt19937 random(5);
        std::vector<Time> pictures;
        std::vector<Time> sharp;
        for (int i = 0; i < zooms && status == 0; ++i) {
            // Any range from one second to the whole file, at any position.
            const double span = all * std::pow(1 / all, static_cast<double>(i) / (zooms - 1));
            const double start = std::uniform_real_distribution<double>(0, std::max(0.0, all - span))(random);
            pictures.push_back(timeOf([&] {
                view.showRange(start, start + span);
                draw();
            }));
            sharp.push_back(timeOf([&] {
                view.showSharp();
                draw();
            }));
            std::fprintf(stderr, "%10.2f s shown: %7.1f ms, sharp after %7.1f ms more\n", span,
                         pictures.back().cpu * 1e3, sharp.back().cpu * 1e3);
        }
        if (status == 0) {
            print("any place, any zoom", pictures);
            print("until it is as sharp as the screen", sharp);
            std::printf("memory of the history: %.1f MB\n", static_cast<double>(store.memoryBytes()) * 1e-6);
        }
    }
    if (status != 0) {
        std::fprintf(stderr, "%s cannot be shown\n", qPrintable(path));
    }
    if (!keep) {
        QFile::remove(path);
    }
    return status;
}
