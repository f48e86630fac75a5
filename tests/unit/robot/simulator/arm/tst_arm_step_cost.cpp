// SPDX-License-Identifier: MIT
// A simulation step of the arm neither allocates nor frees memory for any kind of motion. With --cost, the
// program prints the time per step [ns].
#include <QTest>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>

#include "tests/unit/robot/simulator/arm/arm_fixture.h"

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || !defined(__GLIBC__)
#define COUNTS_ALLOCATIONS 0
#else
#define COUNTS_ALLOCATIONS 1
namespace {
thread_local long g_allocations = 0;
}
extern "C" void* __libc_malloc(std::size_t size);
extern "C" void* malloc(std::size_t size) {
    ++g_allocations;
    return __libc_malloc(size);
}
#endif

using namespace tiller;
using namespace tiller::simulator::arm;

namespace {
template <class Each>
double nanosecondsPerStep(WatchedArm& arm, int steps, Each&& each) {
    // CPU time, so that other programs on the machine have no effect.
    const std::clock_t start = std::clock();
    for (int n = 0; n < steps; ++n) {
        each(n);
        arm->step();
    }
    return 1e9 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC / steps;
}

void printCost() {
    const auto report = [](const char* what, double cost) {
        std::printf("%-28s %7.0f ns/step\n", what, cost);
    };
    {
        WatchedArm arm(false);
        report("standstill", nanosecondsPerStep(arm, 50000, [](int) {}));
    }
    {
        WatchedArm arm(false);
        report("movej", nanosecondsPerStep(arm, 50000, [&](int n) {
                   if (n % 2000 == 0) {
                       arm->motion().moveJ(
                           JointPositions(n % 4000 == 0 ? -1 : -1.6, -1.7, -2.2, -0.8, 1.6, 0),
                           {.a = 1.4, .v = 1.05});
                   }
               }));
    }
    {
        WatchedArm arm(false);
        report("speedl, repeated", nanosecondsPerStep(arm, 50000, [&](int n) {
                   const double v = n % 2000 < 1000 ? 0.05 : -0.05;
                   arm->motion().speedL({{v, 0, 0}, {0, 0, v}}, 0.5, 0.002);
               }));
    }
    {
        WatchedArm arm(false);
        Pose pose = arm.state().targetTcpPose;
        report("movel, planning included", nanosecondsPerStep(arm, 50000, [&](int n) {
                   if (n % 1000 == 0) {
                       pose.position.x() += n % 2000 == 0 ? 0.2 : -0.2;
                       arm->motion().moveL(pose, {.a = 1.2, .v = 0.25});
                   }
               }));
    }
}
}  // namespace

class TestArmStepCost : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void nothingAllocates();
};

void TestArmStepCost::nothingAllocates() {
#if COUNTS_ALLOCATIONS
    WatchedArm arm(false);
    arm->environment().addPlane({.point = {0, 0, -1}});
    Pose pose = arm.state().targetTcpPose;
    arm.run(0.1);
    void* probe = std::malloc(16);
    QVERIFY2(g_allocations > 0, "allocations are not counted");
    std::free(probe);
    const long before = g_allocations;
    Motion& motion = arm->motion();
    motion.moveJ(JointPositions(-1.4, -1.7, -2.0, -0.8, 1.6, 0), {.a = 3, .v = 2, .r = 0.02});
    arm.run(0.3);
    pose.position.x() += 0.1;
    motion.moveL(pose, {.a = 1.2, .v = 0.25});
    arm.run(1);
    motion.speedL({{0, 0, 0.05}, {0, 0, 0.1}}, 0.5, 0.5);
    arm.run(0.3);
    motion.stopL(2);
    arm.run(0.3);
    motion.speedJ(JointVelocities(0.1, 0, 0, 0, 0, 0), 1, 0.2);
    arm.run(0.2);
    motion.servoJ(arm.state().targetQ, 0.1);
    arm.run(0.2);
    motion.directTorque(JointTorques(), Vector6::Ones(), Vector6::Ones());
    arm.run(0.1);
    ForceModeParameters force;
    force.compliant[2] = true;
    arm->compliance().startForceMode(force);
    arm.run(0.2);
    arm->compliance().endForceMode();
    arm->compliance().startFreedrive();
    arm.run(0.2);
    arm->compliance().endFreedrive();
    arm->setPayload({.mass = 1});
    arm.run(0.2);
    QCOMPARE(g_allocations - before, 0L);
    QVERIFY(!arm->protectiveStop());
#else
    QSKIP("allocations are not counted with a sanitizer");
#endif
}

int main(int argc, char** argv) {
    if (argc > 1 && std::strcmp(argv[1], "--cost") == 0) {
        printCost();
        return 0;
    }
    TestArmStepCost test;
    return QTest::qExec(&test, argc, argv);
}

#include "tst_arm_step_cost.moc"
