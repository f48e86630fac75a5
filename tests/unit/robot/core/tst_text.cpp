// SPDX-License-Identifier: MIT
#include <QTest>
#include <numbers>

#include "robot/core/error.h"
#include "robot/core/joints.h"
#include "robot/core/modes.h"
#include "robot/core/robot_model.h"
#include "robot/core/spatial.h"
#include "robot/core/text.h"
#include "robot/core/version.h"

using namespace tiller;

namespace {

enum class Plain { First, Second = 200 };
enum class Bits : std::uint32_t { Low = 1, High = 1U << 30 };
enum class Below : std::int8_t { Minus = -1, Zero };

std::string given(const Text& text) {
    return text;
}

}  // namespace

class TestText : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void acceptsAndReturnsEveryStringType() {
        const char* const letters =
            "P\xc3\xbc"
            "ppchen";
        QCOMPARE(given(std::string(letters)), std::string(letters));
        QCOMPARE(given(letters), std::string(letters));
        QCOMPARE(given(std::string_view(letters)), std::string(letters));
        QCOMPARE(given(QString::fromUtf8(letters)), std::string(letters));
        QCOMPARE(given(QLatin1String("abc")), std::string("abc"));
        QCOMPARE(given({}), std::string());
        Text text = std::string("x");
        text = QStringLiteral("y");
        const QString back = text;
        QCOMPARE(back, "y");
        QCOMPARE(toString(text), std::string("y"));
    }

    void enumeratorsHaveNames() {
        QCOMPARE(toString(Plain::First), std::string("First"));
        QCOMPARE(toString(Plain::Second), std::string("Second"));
        QCOMPARE(toString(static_cast<Plain>(7)), std::string("7"));
        QCOMPARE(toString(Bits::High), std::string("High"));
        QCOMPARE(toString(static_cast<Bits>(3)), std::string("3"));
        QCOMPARE(toString(Below::Minus), std::string("Minus"));
        QCOMPARE(toString(Below::Zero), std::string("Zero"));
        QCOMPARE(toString(RobotModelId::UR8Long), std::string("UR8Long"));
        for (int code = 0; code <= static_cast<int>(ErrorCode::Internal); ++code) {
            const auto value = static_cast<ErrorCode>(code);
            QCOMPARE(toString(value), errorCodeName(value).toStdString());
        }
    }

    void modesHaveTheControllersSpelling() {
        QCOMPARE(toString(RobotMode::PowerOff), std::string("POWER_OFF"));
        QCOMPARE(toString(SafetyMode::ProtectiveStop), std::string("PROTECTIVE_STOP"));
        QCOMPARE(toString(RuntimeState::Playing), std::string("PLAYING"));
        QCOMPARE(toString(JointMode::Idle), std::string("IDLE"));
        QCOMPARE(toString(static_cast<RobotMode>(77)), std::string("UNKNOWN_77"));
    }

    void valuesAreFormatted() {
        QCOMPARE(toString(JointPositions(0, -1.5, 0.25, 0, 0, 6)), std::string("[0, -1.5, 0.25, 0, 0, 6]"));
        QCOMPARE(toString(Pose(1, 2, 3, 0, 0, 0.5)), std::string("p[1, 2, 3, 0, 0, 0.5]"));
        QCOMPARE(toString(Twist{{1, 2, 3}, {4, 5, 6}}), std::string("[1, 2, 3, 4, 5, 6]"));
        QCOMPARE(toString(Wrench{{1, 2, 3}, {4, 5, 6}}), std::string("[1, 2, 3, 4, 5, 6]"));
        QCOMPARE(toString(SoftwareVersion{5, 21, 1, 0}), std::string("5.21.1.0"));
        const Error error{ErrorCode::LinkLost, Text(std::string("jog")), "no data"};
        QCOMPARE(toString(error), std::string("LinkLost: jog (no data)"));
        QCOMPARE(error.message(), toString(error));
    }

    void jointsConvertToRangeAndVector() {
        JointPositions q(1, 2, 3, 4, 5, 6);
        double sum = 0;
        for (const double value : q) {
            sum += value;
        }
        QCOMPARE(sum, 21.0);
        for (double& value : q) {
            value *= 2;
        }
        QVERIFY(q == JointPositions(2, 4, 6, 8, 10, 12));
        QVERIFY(q + q == 2 * q);
        QVERIFY(q - q == JointPositions());
        QVERIFY(-q == q * -1);
        q += JointPositions(1, 0, 0, 0, 0, 0);
        QCOMPARE(q[0], 3.0);
        const std::vector<double> list = q.toStdVector();
        QCOMPARE(list, (std::vector<double>{3, 4, 6, 8, 10, 12}));
        QVERIFY(JointPositions(list) == q);
        QVERIFY(JointPositions(q.array()) == q);
        QVERIFY_EXCEPTION_THROWN(JointPositions(std::vector<double>(5)), std::invalid_argument);
    }

    void posesAreMultiplied() {
        const Pose T_base_tool(1, 0, 0, 0, 0, std::numbers::pi / 2);
        const Pose T_tool_point(0.5, 0, 0, 0, 0, 0);
        const Pose T_base_point = T_base_tool * T_tool_point;
        QVERIFY((T_base_point.position - Eigen::Vector3d(1, 0.5, 0)).norm() < 1e-12);
        QVERIFY((T_base_tool * T_tool_point.position - T_base_point.position).norm() < 1e-12);
        const Pose none = T_base_tool.inverse() * T_base_tool;
        QVERIFY(none.position.norm() < 1e-12 && none.rotation.norm() < 1e-12);
        QCOMPARE(T_base_point[1], T_base_point.position.y());
        QVERIFY(Pose::fromStdVector(T_base_point.toStdVector()) == T_base_point);
        QVERIFY_EXCEPTION_THROWN(Pose::fromStdVector({1, 2}), std::invalid_argument);
        QVERIFY((2 * Twist{{1, 0, 0}, {0, 1, 0}} == Twist{{2, 0, 0}, {0, 2, 0}}));
        QVERIFY(
            (Wrench{{1, 0, 0}, {0, 0, 0}} + Wrench{{0, 1, 0}, {0, 0, 0}} == Wrench{{1, 1, 0}, {0, 0, 0}}));
    }
};

QTEST_GUILESS_MAIN(TestText)
#include "tst_text.moc"
