// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measures the cost of the 3D view in the GUI thread at 1200 x 700 while the arm is jogged: with and without
// a ghost, with a cell, and while the view is rotated. Also measures the time from a selection until its
// ghost is drawn. Uses processor time, so that other processes have no effect.
//
// scene_cost [--frames N]

#include <QApplication>
#include <QImage>
#include <QKeyEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <functional>
#include <vector>

#include "widgets/common/theme.h"
#include "widgets/scene/scene_view.h"

using namespace tiller;

namespace {

const QSize kSize(1200, 700);

double milliseconds(const std::function<void()>& work) {
    const std::clock_t from = std::clock();
    work();
    return static_cast<double>(std::clock() - from) / CLOCKS_PER_SEC * 1e3;
}

struct Summary {
    double median = 0, p99 = 0;
};

Summary print(const char* name, std::vector<double> times) {
    std::sort(times.begin(), times.end());
    const auto at = [&](double share) {
        return times[static_cast<std::size_t>(share * static_cast<double>(times.size() - 1))];
    };
    std::printf("  %-44s %8.2f %8.2f %8.2f\n", name, at(0.5), at(0.99), times.back());
    return {at(0.5), at(0.99)};
}

collision::Surroundings cell() {
    collision::Surroundings result;
    result.borders.push_back({{}, Pose(0, 0, -0.02, 0, 0, 0)});
    result.borders.push_back({"fence", Pose(-0.9, 0, 0.5, 0, 1.5708, 0)});
    for (int i = 0; i < 6; ++i) {
        result.obstacles.push_back(
            {"crate", Pose(0.5 * std::cos(i), 0.5 * std::sin(i), 0.06, 0, 0, 0.3 * i), {0.1, 0.14, 0.12}});
    }
    return result;
}

struct Bench {
    SceneView view;
    QImage image{kSize, QImage::Format_ARGB32_Premultiplied};
    JointPositions q{-1.6007, -1.7271, -2.2030, -0.8080, 1.5951, -0.0310};

    Bench() {
        view.resize(kSize);
        SessionState state;
        state.link = LinkState::Live;
        state.sequence = 1;
        state.q = q;
        state.tcpOffset = Pose(0, 0, 0.12, 0, 0, 0);
        view.setState(state);
        view.setJogDirection(SceneJog{{1, 0, 0}, QStringLiteral("X+ Base"), 0});
        frame();
    }
    void frame() {
        QPainter painter(&image);
        view.paintScene(painter, kSize);
    }
    std::vector<double> jogged(int frames) {
        std::vector<double> times;
        for (int i = 0; i < frames; ++i) {
            q[0] += i % 400 < 200 ? 0.002 : -0.002;
            times.push_back(milliseconds([&] {
                view.setJoints(q);
                frame();
            }));
        }
        return times;
    }
    Ghost ghost(int i, bool linear) const {
        Ghost result;
        result.name = QStringLiteral("waypoint %1").arg(i);
        result.q = q;
        result.q[0] += 0.3 + 0.01 * (i % 40);
        result.q[1] -= 0.1;
        result.linear = linear;
        return result;
    }
};

}  // namespace

int main(int argc, char** argv) {
    int frames = 300;
    for (int i = 1; i + 1 < argc; ++i) {
        if (std::strcmp(argv[i], "--frames") == 0) {
            frames = std::max(20, std::atoi(argv[i + 1]));
        }
    }
    if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) {
        qputenv("QT_QPA_PLATFORM", "offscreen");
    }
    QApplication application(argc, argv);
    applyTheme(application, Theme::light());
    std::printf("Cost of the view, %d x %d, %d frames each [ms]%13s %8s %8s\n", kSize.width(), kSize.height(),
                frames, "median", "99 %", "most");

    Bench bench;
    const Summary alone = print("jogging", bench.jogged(frames));
    bench.view.setGhost(bench.ghost(0, false));
    const Summary ghost = print("jogging, with a ghost", bench.jogged(frames));
    bench.view.setSurroundings({.around = cell(), .unplaced = {}});
    const Summary all = print("jogging, with a ghost, in a cell", bench.jogged(frames));
    std::vector<double> turned;
    for (int i = 0; i < frames; ++i) {
        turned.push_back(milliseconds([&] {
            QKeyEvent key(QEvent::KeyPress, i % 100 < 50 ? Qt::Key_Left : Qt::Key_Right, Qt::NoModifier);
            QApplication::sendEvent(&bench.view, &key);
            bench.frame();
        }));
    }
    print("turning the picture, with all of this", turned);
    std::vector<double> still;
    for (int i = 0; i < frames; ++i) {
        still.push_back(milliseconds([&] { bench.frame(); }));
    }
    print("painted again, nothing has changed", still);
    std::vector<double> selected;
    for (int i = 0; i < frames; ++i) {
        selected.push_back(milliseconds([&] {
            bench.view.setGhost(bench.ghost(i, i % 2 == 0));
            bench.frame();
        }));
    }
    const Summary selection = print("a selection, until its ghost is drawn", selected);

    constexpr double kFrame = 1000.0 / 60;
    constexpr double kGhost = 50;
    std::printf(
        "a frame of 60 a second has %.1f ms; of them jogging takes %.0f %%, with ghost and cell %.0f %%\n",
        kFrame, 100 * alone.median / kFrame, 100 * std::max(ghost.median, all.median) / kFrame);
    const bool ok = all.median < kFrame && selection.p99 < kGhost;
    std::printf("%s\n", ok ? "PASS" : "FAIL");
    return ok ? 0 : 1;
}
