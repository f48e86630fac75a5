// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measures the cost of one frame in the GUI thread: the plots with a short and a long history, zoomed in and
// out, and the scene. Prints percentiles and the ratios that must be below 1.2. The times depend on the
// computer, but the ratios do not.
//
// frame_cost [--frames N]

#include <QApplication>
#include <QImage>
#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <functional>
#include <memory>
#include <vector>

#include "robot/station/history/plot_marks.h"
#include "robot/station/history/signal_store.h"
#include "robot/station/history/state_lane.h"
#include "widgets/common/theme.h"
#include "widgets/plots/curve.h"
#include "widgets/plots/curve_raster.h"
#include "widgets/plots/plot_view.h"
#include "widgets/scene/scene_view.h"

using namespace tiller;

namespace {

constexpr double kPeriod = 0.002;  // [s]
constexpr int kWidth = 1430;       // width of a plot in the default layout [px]
constexpr int kHeight = 130;
constexpr int kCurves = 12;

struct Percentiles {
    double p50 = 0, p90 = 0, p99 = 0, most = 0;
};

Percentiles percentiles(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const auto at = [&values](double share) {
        return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
    };
    return {at(0.5), at(0.9), at(0.99), values.back()};
}

/// Returns processor time instead of wall time, so that other processes have no effect.
double seconds(const std::function<void()>& work) {
    const std::clock_t from = std::clock();
    work();
    return static_cast<double>(std::clock() - from) / CLOCKS_PER_SEC;
}

/// A signal similar to that of a robot: slow movement with noise.
/// stretch  factor for the duration of the movement; a history that is longer by this factor looks the same
float signalAt(std::int64_t sample, int signal, double stretch) {
    const double t = static_cast<double>(sample) * kPeriod / stretch;
    const auto noise = static_cast<double>((static_cast<std::uint32_t>(sample) * 2654435761U +
                                            static_cast<std::uint32_t>(signal) * 40503U) >>
                                           20) /
                           4096.0 -
                       0.5;
    return static_cast<float>(8 * std::sin(t * 0.37 + signal) + 2 * std::sin(t * 2.1 * (signal + 1)) + noise);
}

void grow(SeriesBuffer& history, double length, double stretch = 1) {
    std::array<float, kCurves> row{};
    const auto until = static_cast<std::int64_t>(length / kPeriod);
    for (std::int64_t i = history.end(); i < until; ++i) {
        for (int s = 0; s < kCurves; ++s) {
            row[static_cast<std::size_t>(s)] = signalAt(i, s, stretch);
        }
        history.append(static_cast<double>(i) * kPeriod, row);
    }
}

/// One case with twelve curves over the last `span` seconds of a history.
struct CurveCase {
    const char* name;
    SeriesBuffer& history;
    double span;
    std::vector<std::unique_ptr<Curve>> curves = {};
    std::unique_ptr<CurveRaster> sheet = {};
    ColumnGrid grid = {};
    std::vector<double> times = {};
    double end = 0;
    bool zooming = false;  ///< true if the raster changes in every frame, so that no columns are reused

    void frame(QImage& image) {
        // The curves move by the samples of one frame, as with live data.
        end = end == 0 ? history.lastTime() - 20 : end + 0.0166;
        if (end > history.lastTime()) {
            end = history.lastTime() - 20;
        }
        times.push_back(seconds([&] {
            span *= zooming ? 0.9999 : 1.0;
            const double width = span / kWidth;
            history.cut(std::floor((end - span) / width) * width, width, kWidth + 1, grid);
            image.fill(Qt::white);
            QPainter painter(&image);
            for (const auto& curve : curves) {
                curve->sample(history, curve->signal(), grid);
            }
            sheet->setView(QRectF(0, 0, kWidth, kHeight), end - span, end, -12, 12);
            sheet->paint(&painter, nullptr, nullptr);
        }));
    }
};

void print(const char* name, const std::vector<double>& times) {
    const Percentiles p = percentiles(times);
    std::printf("  %-46s %8.3f %8.3f %8.3f %8.3f\n", name, p.p50 * 1e3, p.p90 * 1e3, p.p99 * 1e3,
                p.most * 1e3);
}

double median(const std::vector<double>& times) {
    return percentiles(times).p50;
}

}  // namespace

int main(int argc, char** argv) {
    int frames = 200;
    for (int i = 1; i + 1 < argc; ++i) {
        if (std::strcmp(argv[i], "--frames") == 0) {
            frames = std::max(10, std::atoi(argv[i + 1]));
        }
    }
    if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) {
        qputenv("QT_QPA_PLATFORM", "offscreen");
    }
    QApplication application(argc, argv);
    applyTheme(application, Theme::light());

    SeriesBuffer shortHistory(kCurves);
    SeriesBuffer longHistory(kCurves);
    grow(shortHistory, 60);  // 30 s are displayed, and the rest is used for scrolling
    grow(longHistory, 30 * 60 + 30);
    SeriesBuffer slowHistory(kCurves);
    grow(slowHistory, 30 * 60 + 30, 1790.0 / 30.0);

    std::vector<CurveCase> cases;
    cases.push_back({"30 s shown of 30 s", shortHistory, 30});
    cases.push_back({"30 s shown of 30 min", longHistory, 30});
    cases.push_back({"30 min shown of 30 min, the same picture", slowHistory, 1790});
    cases.push_back({"30 min shown of 30 min, filling the plot", longHistory, 1790});
    cases.back().zooming = true;
    cases.push_back({"2 s shown of 30 min", longHistory, 2});
    for (CurveCase& c : cases) {
        for (int s = 0; s < kCurves; ++s) {
            c.curves.push_back(std::make_unique<Curve>(s));
            QPen pen(Theme::light().curves[static_cast<std::size_t>(s % 6)], 1.6);
            if (s % 6 > 3) {
                pen.setDashPattern({6, 3});
            }
            c.curves.back()->setPen(pen);
        }
        c.sheet = std::make_unique<CurveRaster>(c.curves, nullptr);
    }
    QImage image(kWidth, kHeight, QImage::Format_ARGB32_Premultiplied);
    // The cases alternate, so that load on the computer affects all of them.
    for (int i = 0; i < frames; ++i) {
        for (CurveCase& c : cases) {
            c.frame(image);
        }
    }

    StateLane lane;
    SignalStore store;
    std::vector<SeriesBuffer::Row> rows;
    for (std::int64_t i = 0; i < static_cast<std::int64_t>(1830 / kPeriod); ++i) {
        rows.push_back({static_cast<double>(i) * kPeriod, false});
    }
    store.appendLive(rows, [](std::size_t column, std::size_t row) {
        return signalAt(static_cast<std::int64_t>(row), static_cast<int>(column) % kCurves, 1);
    });
    PlotMarks marks(store);
    PlotView view(store, lane, marks);
    view.resize(1500, 342);
    view.refresh(0);
    QImage panel(1500, 342, QImage::Format_ARGB32_Premultiplied);
    std::vector<double> viewTimes;
    for (int i = 0; i < frames; ++i) {
        viewTimes.push_back(seconds([&] {
            view.scrollBy(i % 2 == 0 ? -0.0166 : 0.0083);
            panel.fill(Qt::white);
            QPainter painter(&panel);
            view.render(&painter);
        }));
    }

    SceneView scene;
    scene.setStale(false);
    JointPositions q(-1.6007, -1.7271, -2.2030, -0.8080, 1.5951, -0.0310);
    Ghost ghost;
    ghost.q = q;
    ghost.q[0] += 0.4;
    scene.setJoints(q);
    scene.setGhost(ghost);
    scene.setJogDirection(SceneJog{{1, 0, 0}, QStringLiteral("X+ Base"), 0});
    QImage arm(930, 520, QImage::Format_ARGB32_Premultiplied);
    std::vector<double> sceneTimes;
    for (int i = 0; i < frames; ++i) {
        q[0] += 0.002;
        sceneTimes.push_back(seconds([&] {
            scene.setJoints(q);
            arm.fill(Qt::white);
            QPainter painter(&arm);
            scene.paintScene(painter, arm.size());
        }));
    }

    std::printf("Frame cost, %d frames each [ms]%33s %8s %8s %8s\n", frames, "median", "90 %", "99 %",
                "most");
    std::printf("12 curves, %d x %d px, 500 Hz\n", kWidth, kHeight);
    for (const CurveCase& c : cases) {
        print(c.name, c.times);
    }
    print("whole plot panel, 9 curves, 1500 x 342 px", viewTimes);
    print("scene with ghost, 930 x 520 px", sceneTimes);
    const double base = median(cases[0].times);
    const double history = median(cases[1].times) / base;
    const double zoomedOut = median(cases[2].times) / base;
    const double zoomedIn = median(cases[4].times) / median(cases[2].times);
    std::printf("ratio, 30 s shown: 30 min of history to 30 s     %.3f  (must be below 1.2)\n", history);
    std::printf("ratio, the same picture of 30 min and of 30 s    %.3f  (aim: below 1.2)\n", zoomedOut);
    std::printf("ratio, zoomed in to zoomed out                   %.3f  (must be below 1.2)\n", zoomedIn);
    std::printf("memory of the history, 12 signals, 35 min        %.1f MB\n",
                static_cast<double>(longHistory.memoryBytes()) / 1e6);
    const bool ok = history < 1.2 && zoomedIn < 1.2;
    std::printf("%s\n", ok ? "PASS" : "FAIL");
    return ok ? 0 : 1;
}
