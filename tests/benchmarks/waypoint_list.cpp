// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measures the cost of a list with 2000 waypoints in the GUI thread: scrolling, searching, and an edit.
// Prints the processor time of single steps. None of them may block the window for 50 ms.
//
// waypoint_list [--waypoints N]

#include <QAction>
#include <QApplication>
#include <QLineEdit>
#include <QScrollBar>
#include <QTest>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <vector>

#include "robot/kinematics/arm_kinematics.h"
#include "widgets/common/theme.h"
#include "widgets/hold/hold_rules.h"
#include "widgets/project/undoable_document.h"
#include "widgets/waypoints/waypoint_table.h"
#include "widgets/waypoints/waypoints_tab.h"

using namespace tiller;

namespace {

constexpr double kStallMs = 50;

/// Returns processor time instead of wall time, so that other processes have no effect [ms].
double cost(const std::function<void()>& work) {
    const std::clock_t from = std::clock();
    work();
    QApplication::processEvents();
    return 1e3 * static_cast<double>(std::clock() - from) / CLOCKS_PER_SEC;
}

bool print(const char* what, std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const double most = values.back();
    std::printf("%-28s %6zu steps   p50 %7.2f ms   p99 %7.2f ms   most %7.2f ms   %s\n", what, values.size(),
                values[values.size() / 2], values[values.size() * 99 / 100], most,
                most <= kStallMs ? "ok" : "STALLS");
    return most <= kStallMs;
}

}  // namespace

int main(int argc, char** argv) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    QApplication application(argc, argv);
    applyTheme(application, Theme::light());
    const int count = argc == 3 ? std::max(1, std::atoi(argv[2])) : 2000;

    RobotSession session;
    session.shutDown();
    UndoableDocument document;
    HoldPolicy policy;
    WaypointsTab tab(session, document, policy);
    tab.resize(560, 560);
    tab.show();
    project::Project cell;
    const RobotModel& model = robotModel(RobotModelId::UR5e);
    for (int i = 0; i < count; ++i) {
        project::Waypoint point;
        point.id = QUuid::createUuid();
        point.name = QStringLiteral("waypoint %1").arg(i + 1);
        point.group = QStringLiteral("group %1").arg(i % 17);
        point.note = QStringLiteral("a note of some length about the place with the number %1").arg(i * 7);
        point.joints = JointPositions(-1.6 + 0.001 * i, -1.7, -2.2, -0.8, 1.6, 0);
        point.priority = i % 2 == 0 ? project::TargetKind::Pose : project::TargetKind::Joints;
        point.pose = kinematics::forwardTcp(model.dh, point.joints);
        cell.waypoints.append(point);
    }
    const double opened = cost([&] { document.setProject(cell); });
    std::printf("opening %d waypoints: %.1f ms\n", count, opened);

    auto& table = *tab.findChild<WaypointTable*>();
    QScrollBar& bar = *table.verticalScrollBar();
    std::vector<double> scrolled;
    for (int i = 0; i <= 200; ++i) {
        scrolled.push_back(cost([&] {
            bar.setValue(bar.maximum() * i / 200);
            table.viewport()->repaint();
        }));
    }
    bool good = print("scrolling", scrolled);

    std::vector<double> stepped;
    for (int i = 0; i < 100; ++i) {
        stepped.push_back(cost([&] {
            tab.selectRow((i * 37) % count);
            table.viewport()->repaint();
        }));
    }
    good = print("selecting", stepped) && good;

    tab.findChild<QAction*>(QStringLiteral("waypoint.action.find"))->trigger();
    auto& field = *tab.findChild<QLineEdit*>(QStringLiteral("waypoint.search.field"));
    std::vector<double> searched;
    for (const char* word : {"waypoint 19", "group 3", "number 70", "zzz", "7"}) {
        field.clear();
        for (const char* letter = word; *letter != '\0'; ++letter) {
            searched.push_back(cost([&] {
                QTest::keyClick(&field, *letter);
                table.viewport()->repaint();
            }));
        }
        searched.push_back(cost([&] { field.clear(); }));
    }
    good = print("searching, a letter", searched) && good;
    QTest::keyClick(&field, Qt::Key_Escape);

    std::vector<double> edited;
    for (int i = 0; i < 50; ++i) {
        edited.push_back(cost([&] {
            project::Waypoint point = document.waypoints().at(i);
            point.blend += 0.001;
            document.changeWaypoint(i, point, QStringLiteral("Set the blend"));
        }));
        edited.push_back(cost([&] { document.undoStack().undo(); }));
    }
    good = print("an edit and its undo", edited) && good;
    return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
