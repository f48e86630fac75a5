// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measures the cost of the plots with an hour of history: adding every packet, and drawing 24 curves with a
// width of 1920 px while the view follows, pans and zooms. Prints processor time and wall time. Wall time
// includes effects of other processes.
//
// Each time is followed by its parts: the look-up of 24 curves in the pixel columns, the painting of these
// columns and the scales (Tiller's code), and Qt's drawing of the scene (axes, labels, legends, and copying
// of images).
//
// plot_cost [--frames N] [--hours H] [--only WORD]

#include <QApplication>
#include <QImage>
#include <QPainter>
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "robot/receive/receiver.h"
#include "robot/station/history/plot_marks.h"
#include "robot/station/history/signal_store.h"
#include "robot/station/history/state_lane.h"
#include "widgets/common/theme.h"
#include "widgets/plots/curve.h"
#include "widgets/plots/plot_pane.h"
#include "widgets/plots/plot_view.h"

using namespace tiller;

namespace {

constexpr double kPeriod = 0.002;  // [s]
constexpr int kCurves = 24;
constexpr std::int64_t kPacketsPerFrame = 8;

/// Processor time of this thread [ms].
double cpuNow() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) / 1e6;
}

struct Times {
    std::vector<double> cpu;   // [ms]
    std::vector<double> wall;  // [ms]

    void measure(const std::function<void()>& work) {
        const auto begin = std::chrono::steady_clock::now();
        const double from = cpuNow();
        work();
        cpu.push_back(cpuNow() - from);
        const auto end = std::chrono::steady_clock::now();
        wall.push_back(std::chrono::duration<double, std::milli>(end - begin).count());
    }
};

/// Parts of a frame [ms of processor time].
struct Parts {
    Times lookUp;  // repeated outside the view with separate curves
    Times show;    // work of the view: look-up, painting of columns, scales
    Times draw;    // work of Qt
};

struct Row {
    std::string name;
    double limit;  // [ms]
    Times whole;
    Parts parts;
};

double percentile(std::vector<double> values, double share) {
    std::sort(values.begin(), values.end());
    return values.empty() ? 0
                          : values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

void print(const Row& row) {
    const double p99 = percentile(row.whole.cpu, 0.99);
    const double lookUp = percentile(row.parts.lookUp.cpu, 0.99);
    const double shown = percentile(row.parts.show.cpu, 0.99);
    std::printf("  %-44s %8.3f %8.3f | %8.3f %8.3f | %7.2f %7.2f %7.2f   limit %g ms: %s\n", row.name.c_str(),
                percentile(row.whole.cpu, 0.5), p99, percentile(row.whole.wall, 0.5),
                percentile(row.whole.wall, 0.99), lookUp, std::max(0.0, shown - lookUp),
                percentile(row.parts.draw.cpu, 0.99), row.limit, p99 <= row.limit ? "holds" : "EXCEEDED");
}

/// Slow movement with noise, like the signals of a robot.
double signalAt(std::int64_t sample, std::size_t column) {
    const double t = static_cast<double>(sample) * kPeriod;
    const auto noise = static_cast<double>((static_cast<std::uint32_t>(sample) * 2654435761U +
                                            static_cast<std::uint32_t>(column) * 40503U) >>
                                           20) /
                           4096.0 -
                       0.5;
    return 8 * std::sin(t * 0.37 + static_cast<double>(column)) + noise;
}

/// Six curves in each of four plots.
PageLayout fourPlots() {
    PageLayout page;
    for (const char* field : {"actual_q", "actual_qd", "actual_current", "target_q"}) {
        QStringList keys;
        for (int i = 0; i < 6; ++i) {
            keys << QStringLiteral("%1_%2").arg(QLatin1String(field)).arg(i);
        }
        page.panes.append({keys, {}, 0, 1});
    }
    return page;
}

/// Appends every packet with all fields, frame by frame.
Times append(std::int64_t packets) {
    SignalStore store(HistoryLimits{7200, std::size_t{4} << 30});
    const std::size_t columns = store.liveColumns().size();
    std::vector<std::vector<double>> values(kPacketsPerFrame, std::vector<double>(columns));
    std::array<SeriesBuffer::Row, kPacketsPerFrame> rows{};
    Times times;
    for (std::int64_t at = 0; at < packets; at += kPacketsPerFrame) {
        for (std::int64_t i = 0; i < kPacketsPerFrame; ++i) {
            rows[static_cast<std::size_t>(i)] = {static_cast<double>(at + i) * kPeriod, false};
            for (std::size_t c = 0; c < columns; ++c) {
                values[static_cast<std::size_t>(i)][c] = signalAt(at + i, c);
            }
        }
        times.measure(
            [&] { store.appendLive(rows, [&](std::size_t c, std::size_t row) { return values[row][c]; }); });
    }
    for (auto* list : {&times.cpu, &times.wall}) {
        for (double& time : *list) {
            time /= kPacketsPerFrame;
        }
    }
    return times;
}

}  // namespace

int main(int argc, char** argv) {
    int frames = 300;
    double hours = 1;
    std::string only;
    for (int i = 1; i + 1 < argc; ++i) {
        if (std::strcmp(argv[i], "--only") == 0) {
            only = argv[i + 1];
        } else if (std::strcmp(argv[i], "--frames") == 0) {
            frames = std::max(20, std::atoi(argv[i + 1]));
        } else if (std::strcmp(argv[i], "--hours") == 0) {
            hours = std::clamp(std::atof(argv[i + 1]), 0.01, 8.0);
        }
    }
    if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) {
        qputenv("QT_QPA_PLATFORM", "offscreen");
    }
    QApplication application(argc, argv);
    applyTheme(application, Theme::light());

    const Times appended = append(40'000);

    SignalStore store(HistoryLimits{hours * 3600 + 60, std::size_t{8} << 30});
    StateLane lane;
    const PageLayout page = fourPlots();
    std::vector<int> noisy;
    for (const PaneLayout& pane : page.panes) {
        for (const QString& key : pane.shown) {
            noisy.push_back(store.column(store.find(key)));
        }
    }
    std::vector<std::uint8_t> isNoisy(store.liveColumns().size());
    for (const int column : noisy) {
        isNoisy[static_cast<std::size_t>(column)] = 1;
    }
    const auto total = static_cast<std::int64_t>(hours * 3600 / kPeriod);
    const auto grow = [&](std::int64_t from, std::int64_t to) {
        std::vector<SeriesBuffer::Row> rows;
        for (std::int64_t i = from; i < to; ++i) {
            rows.push_back({static_cast<double>(i) * kPeriod, false});
        }
        store.appendLive(rows, [&](std::size_t c, std::size_t row) {
            return isNoisy[c] != 0 ? signalAt(from + static_cast<std::int64_t>(row), c) : 0.0;
        });
    };
    for (std::int64_t at = 0; at < total; at += 100'000) {
        grow(at, std::min(total, at + 100'000));
    }
    SeriesBuffer plain(kCurves, HistoryLimits{hours * 3600 + 60, std::size_t{8} << 30});
    for (std::int64_t at = 0; at < total; at += 100'000) {
        std::vector<SeriesBuffer::Row> rows;
        for (std::int64_t i = at; i < std::min(total, at + 100'000); ++i) {
            rows.push_back({static_cast<double>(i) * kPeriod, false});
        }
        plain.appendRows(rows, [&](std::size_t c, std::size_t row) {
            return signalAt(at + static_cast<std::int64_t>(row), c);
        });
    }
    const double raw = static_cast<double>(total) * kCurves * sizeof(float);
    const double ratio = static_cast<double>(plain.memoryBytes()) / raw;

    PlotMarks marks(store);
    PlotView view(store, lane, marks);
    view.setPage(page);
    view.setAttribute(Qt::WA_DontShowOnScreen);
    view.resize(1920 + 66, 900);
    view.setVisible(true);
    QCoreApplication::processEvents();
    QImage image(view.size(), QImage::Format_RGB32);
    const auto draw = [&] {
        QPainter painter(&image);
        view.render(&painter);
    };

    std::vector<Row> table;
    std::vector<std::unique_ptr<Curve>> beside;
    for (const PaneLayout& pane : page.panes) {
        for (const QString& key : pane.shown) {
            beside.push_back(std::make_unique<Curve>(store.find(key)));
        }
    }
    const auto add = [&](const std::string& name, double limit, const std::function<void(int)>& step) {
        if (name.find(only) == std::string::npos) {
            return;
        }
        Row row{name, limit, {}, {}};
        const auto lookUp = [&] {
            const ColumnGrid& grid = view.gridOf(store.live());
            for (const auto& curve : beside) {
                curve->sample(store.live(), store.column(curve->signal()), grid);
            }
        };
        step(0);
        draw();
        lookUp();
        for (int i = 1; i <= frames; ++i) {
            row.whole.measure([&] {
                row.parts.show.measure([&] { step(i); });
                row.parts.draw.measure(draw);
            });
            row.parts.lookUp.measure(lookUp);
        }
        table.push_back(std::move(row));
    };
    const double all = hours * 3600;
    // Everything is painted again.
    add("redraw of the whole hour", 8, [&](int i) { view.showRange(0, all - (i % 2) * 1e-3); });
    view.showRange(0, all - 60);
    add("pan, whole hour but a minute", 16, [&](int i) { view.scrollBy(i % 2 == 0 ? -11.3 : 17.9); });
    view.showRange(600, 1200);
    add("pan, 10 min", 16, [&](int i) { view.scrollBy(i % 2 == 0 ? -2.3 : 3.9); });
    view.showRange(900, 902);
    add("pan, 2 s", 16, [&](int i) { view.scrollBy(i % 2 == 0 ? -0.008 : 0.013); });
    add("redraw of 2 s", 8, [&](int i) { view.showRange(900, 902 - (i % 2) * 1e-5); });
    add("zoom, from an hour to 20 s", 16, [&](int i) {
        const double span = all * std::pow(20 / all, static_cast<double>(i) / frames);
        view.showRange(all / 2 - span / 2, all / 2 + span / 2);
    });
    add("zoom, from 20 s to 50 ms", 16, [&](int i) {
        const double span = 20 * std::pow(0.05 / 20, static_cast<double>(i) / frames);
        view.showRange(all / 2 - span / 2, all / 2 + span / 2);
    });
    view.setSpan(30);
    view.follow();
    std::int64_t at = total;
    add("following, 30 s, 8 packets a frame", 8, [&](int) {
        grow(at, at + kPacketsPerFrame);
        at += kPacketsPerFrame;
        view.refresh(1);
    });

    std::printf("Plots with %g h at 500 Hz, %d curves in 4 plots, 1920 px wide, %d frames each [ms]\n", hours,
                kCurves, frames);
    std::printf("  %-44s %8s %8s | %8s %8s | %s\n", "", "CPU 50%", "CPU 99%", "wall 50%", "wall 99%",
                "of CPU 99%: look-up, painting, Qt");
    for (const Row& row : table) {
        print(row);
    }
    std::printf("append a packet of %zu numbers [us]: CPU median %.2f, 99 %% %.2f (limit 5)\n",
                store.liveColumns().size(), percentile(appended.cpu, 0.5) * 1e3,
                percentile(appended.cpu, 0.99) * 1e3);
    std::printf("memory: %.1f MB, %.3f of the raw float32 (limit 1.2)\n",
                static_cast<double>(plain.memoryBytes()) / 1e6, ratio);
    const auto median = [&](const char* name) {
        const auto row =
            std::find_if(table.begin(), table.end(), [&](const Row& r) { return r.name == name; });
        return row == table.end() ? 0 : percentile(row->whole.cpu, 0.5);
    };
    const double out = median("redraw of the whole hour");
    const double in = median("redraw of 2 s");
    if (out > 0 && in > 0) {
        std::printf("zoomed in to zoomed out (redraw of 2 s, of the hour): %.3f (limit 1)\n", in / out);
    }
    const bool ok = ratio <= 1.2 && percentile(appended.cpu, 0.5) * 1e3 < 5 && in <= out &&
                    std::all_of(table.begin(), table.end(),
                                [](const Row& row) { return percentile(row.whole.cpu, 0.99) <= row.limit; });
    std::printf("%s\n", ok ? "PASS" : "FAIL");
    return ok ? 0 : 1;
}
