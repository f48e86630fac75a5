// SPDX-License-Identifier: MIT
//
// The table of built-in functions in the simulator's README is generated from the rows that the compiler
// uses. Each function is called on a robot to verify its status in the table.
//
// To regenerate the table: TILLER_UPDATE=1 tst_builtin_table theReadmeIsCurrent

#include <QFile>
#include <QTcpServer>
#include <QTest>
#include <algorithm>
#include <array>
#include <map>

#include "robot/simulator/controller/controller_model.h"
#include "robot/simulator/programs/program_runner.h"
#include "robot/simulator/urscript/builtin_table.h"
#include "robot/simulator/urscript/call.h"
#include "robot/simulator/urscript/program.h"

using namespace tiller;
using namespace tiller::simulator;
using urscript::Builtin;

namespace {

const char* const kBegin = "<!-- builtins: written by tst_builtin_table -->\n";

/// Versions of one series, e.g. "5.21", "5.6 to 5.15", "3.12 or never". Empty: the series never has the
/// function.
QString seriesText(int major, int first, int listed) {
    const QString series = QString::number(major) + QLatin1Char('.');
    if (first == urscript::kNever) {
        return {};
    }
    const QString text = series + QString::number(first);
    return listed == first              ? text
           : listed == urscript::kNever ? text + QStringLiteral(" or never")
                                        : text + QStringLiteral(" to ") + series + QString::number(listed);
}

QString since(const urscript::Since& s) {
    const urscript::FirstVersions& first = s.first;
    const urscript::FirstVersions listed = s.listed.value_or(first);
    QStringList parts{seriesText(3, first.ofSeries3(), listed.ofSeries3()),
                      seriesText(5, first.minor5, listed.minor5)};
    if (first.minor5 == urscript::kNever || first.minor10 > 0 || listed.minor10 > 0) {
        parts << seriesText(10, first.minor10, listed.minor10);
    }
    parts.removeAll(QString());
    const QString text = parts.join(QStringLiteral(", "));
    return text == QLatin1String("3.0, 5.0") ? QStringLiteral("all") : text;
}

/// The option that removes a builtin. No source documents the version in which a builtin was removed.
QString until(const Builtin& b) {
    for (const BehaviourOptionInfo& info : assumptionTable()) {
        BehaviourOptions assumptions;
        const QString words = info.name + QStringLiteral("=missing");
        if (!assume(assumptions, words).ok()) {
            continue;
        }
        const std::vector<std::string> missing = assumptions.missingBuiltins();
        if (std::find(missing.begin(), missing.end(), b.name) != missing.end()) {
            return QStringLiteral("option `%1`").arg(words);
        }
    }
    return {};
}

enum Effect { Full, Partly, Accepted, Refused };
Effect effectOf(const Builtin& b) {
    return b.needs != nullptr                ? Refused
           : b.partly != nullptr             ? Partly
           : b.function == urscript::setting ? Accepted
                                             : Full;
}

QString effectText(const Builtin& b) {
    switch (effectOf(b)) {
        case Full:
            break;
        case Partly:
            return QStringLiteral("partly: %1").arg(QString::fromLatin1(b.partly));
        case Accepted:
            return QStringLiteral("accepted without effect");
        case Refused:
            return QStringLiteral("refused: needs %1").arg(QString::fromLatin1(b.needs));
    }
    return QStringLiteral("full");
}

QString table() {
    std::array<int, 4> counts{};
    QString rows;
    for (const Builtin& b : urscript::builtins()) {
        QString signature = QString::fromStdString(b.signature);
        signature.replace('?', QString());
        signature.replace('|', QStringLiteral(" or "));
        rows += QStringLiteral("| `%1` | %2 | %3 | %4 |\n")
                    .arg(signature, since(b.since), until(b), effectText(b));
        ++counts[effectOf(b)];
    }
    return QStringLiteral(
               "%1 functions: %2 with their full effect, %3 in part, %4 accepted without effect, "
               "%5 refused.\n\n")
               .arg(urscript::builtins().size())
               .arg(counts[Full])
               .arg(counts[Partly])
               .arg(counts[Accepted])
               .arg(counts[Refused]) +
           QStringLiteral("| Function | Since | Until | Effect |\n|---|---|---|---|\n") + rows;
}

/// Returns a plausible argument for a parameter of this name.
QString argument(const std::string& name) {
    static const std::map<std::string, QString> kArguments{
        {"pose", "p[0.3,-0.3,0.3,0,3.14,0]"},
        {"pose_via", "p[0.3,-0.3,0.3,0,3.14,0]"},
        {"pose_to", "p[0.3,-0.2,0.35,0,3.14,0]"},
        {"x", "0.5"},
        {"goal", "[-1.5,-1.7,-2.2,-0.8,1.6,0]"},
        {"q", "[-1.6007,-1.7271,-2.2030,-0.8080,1.5951,-0.0310]"},
        {"qd", "[0,0,0,0,0,0]"},
        {"xd", "[0,0,0,0,0,0]"},
        {"torque", "[0,0,0,0,0,0]"},
        {"cog", "[0,0,0.1]"},
        {"d", "[0,0,9.82]"},
        {"a", "1"},
        {"b", "True"},
        {"f", "0.5"},
        {"t", "0.01"},
        {"r", "1"},
        {"n", "1"},
        {"outputs", "[1]"},
        {"m", "1"},
        {"l", "[True,False]"},
        {"v", "[1,2,3]"},
        {"y", "1"},
        {"value", "1"},
        {"variable_name", "\"input_int_register_0\""},
        {"cond", "True"},
        {"enable", "False"},
        {"enabled", "True"},
        {"str", "\"12\""},
        {"src", "\"abc\""},
        {"target", "\"b\""},
        {"text", "\"?\""},
        {"s", "\"hello\""},
        {"name", "\"f\""},
        {"child", "\"f\""},
        {"frame", "\"f\""},
        {"frame_name", "\"f\""},
        {"parent", "\"tcp\""},
        {"rel_name", "\"base\""},
        {"from_frame", "\"f\""},
        {"to_frame", "\"tcp\""},
        {"inertia", "[0,0,0,0,0,0]"},
        {"key", "\"actual_q\""},
        {"action", "\"default\""},
        {"baud_rate", "115200"},
        {"parity", "0"},
        {"voltage", "24"},
        {"address", "1"},
        {"direction", "p[1,0,0,0,0,0]"},
        {"center", "p[1,0,0,0,0,0]"},
        {"offset", "p[0,0,0,0,0,0]"},
        {"frame_offset", "p[0,0,0,0,0,0]"},
        {"base", "2"},
        {"p_from", "p[0,0,0,0,0,0]"},
        {"p_to", "p[1,0,0,0,0,0]"},
        {"p_1", "p[0,0,0,0,0,0]"},
        {"p_2", "p[1,0,0,0,0,0]"},
        {"p_from_to", "p[1,0,0,0,0,0]"},
        {"T_from_to", "p[1,0,0,0,0,0]"},
        {"w_from", "[1,0,0,0,0,0]"},
        {"rotation_vector", "[1,0,0]"},
        {"rpy_vector", "[1,0,0]"},
        {"task_frame", "p[0,0,0,0,0,0]"},
        {"selection_vector", "[0,0,1,0,0,0]"},
        {"wrench", "[0,0,1,0,0,0]"},
        {"limits", "[1,1,1,1,1,1]"},
        {"damping", "0.1"},
    };
    const auto it = kArguments.find(name);
    return it == kArguments.end() ? QStringLiteral("1") : it->second;
}

/// Calls that need other arguments or a preceding statement.
QString callOf(const Builtin& b) {
    static const std::map<std::string, QString> kCalls{
        {"add_frame", "add_frame(\"g\", p[1,0,0,0,0,0])"},
        {"inv", "inv([[2,0],[0,2]])"},
        {"transpose", "transpose([[1,2]])"},
        {"set_base_acceleration", "set_base_acceleration([0,0,0])"},
        {"get_inverse_kin", "get_inverse_kin(get_actual_tcp_pose())"},
        {"get_inverse_kin_has_solution", "get_inverse_kin_has_solution(get_actual_tcp_pose())"},
        {"movel", "movel(get_actual_tcp_pose())"},
        {"movep", "movep(get_actual_tcp_pose())"},
        {"movec",
         "movec(pose_trans(get_actual_tcp_pose(), p[0.02,0.02,0,0,0,0]), "
         "pose_trans(get_actual_tcp_pose(), p[0.04,0,0,0,0,0]))"},
        {"servoc", "servoc(get_actual_tcp_pose())"},
        {"optimovel", "optimovel(get_actual_tcp_pose())"},
        {"d2r", "d2r(90)"},
        {"integer_to_binary_list", "integer_to_binary_list(5)"},
        {"tool_contact", "tool_contact([0,0,0,0,0,0])"},
        {"log", "log(10, 4)"},
        {"estimate_payload",
         "estimate_payload([p[0,0,0,0,0,0],p[0,0,0,1,0,0],p[0,0,0,0,1,0],p[0,0,0,0,0,1]],"
         "[p[0,0,-10,0,1,0],p[0,0,-10,0,1,0],p[0,0,-10,0,1,0],p[0,0,-10,0,1,0]])"},
        {"encoder_set_tick_count", "encoder_enable_set_tick_count(1, 0)\nencoder_set_tick_count(1, 1)"},
        {"set_conveyor_tick_count", "encoder_enable_set_tick_count(0, 0)\nset_conveyor_tick_count(1)"},
        {"path_offset_set", "path_offset_enable()\npath_offset_set(p[0,0,0,0,0,0], 1)"},
        {"path_offset_get", "path_offset_enable()\np0 = path_offset_get(1)"},
        {"set_tool_communication", "set_tool_communication(True, 115200, 0, 1, 1.5, 3.5)"},
        {"set_runstate_outputs", "set_runstate_outputs([])"},
        {"set_runstate_standard_digital_output_to_value",
         "set_runstate_standard_digital_output_to_value(1, 1)"},
        {"socket_open", "socket_open(\"127.0.0.1\", PORT)"},
        {"rpc_factory", "rpc_factory(\"xmlrpc\", \"http://127.0.0.1:PORT\")"},
        {"eip_writer_factory", "eip_writer_factory(1)"},
        {"modbus_get_signal_status",
         "modbus_add_signal(\"192.168.0.5\", 255, 1, 3, \"s\")\nx = modbus_get_signal_status(\"s\")"},
        {"modbus_get_error", "modbus_add_signal(\"192.168.0.5\", 255, 1, 3, \"s\")\nmodbus_get_error(\"s\")"},
        {"modbus_get_time_since_signal_invalid",
         "modbus_add_signal(\"192.168.0.5\", 255, 1, 3, \"s\")\nmodbus_get_time_since_signal_invalid(\"s\")"},
        {"modbus_set_output_register",
         "modbus_add_signal(\"192.168.0.5\", 255, 1, 3, \"s\")\nmodbus_set_output_register(\"s\", 7)"},
        {"modbus_set_signal_update_frequency",
         "modbus_add_signal(\"192.168.0.5\", 255, 1, 3, \"s\")\nmodbus_set_signal_update_frequency(\"s\", "
         "20)"},
        {"modbus_set_signal_watchdog",
         "modbus_add_signal(\"192.168.0.5\", 255, 1, 3, \"s\")\nmodbus_set_signal_watchdog(\"s\", 5)"},
        {"modbus_set_digital_input_action",
         "modbus_add_signal(\"192.168.0.5\", 255, 1, 3, \"s\")\nmodbus_set_digital_input_action(\"s\", "
         "\"default\")"},
        {"modbus_set_runstate_dependent_choice",
         "modbus_add_signal(\"192.168.0.5\", 255, 1, 3, \"s\")\nmodbus_set_runstate_dependent_choice(\"s\", "
         "1)"},
        {"modbus_add_signal", "modbus_add_signal(\"192.168.0.5\", 255, 1, 3, \"s\")\n"},
        {"modbus_set_output_signal",
         "modbus_add_signal(\"192.168.0.5\", 255, 1, 1, \"c\")\nmodbus_set_output_signal(\"c\", True)"},
        {"modbus_add_rw_signal", "modbus_add_rw_signal(\"192.168.0.5\", 255, 1, 2, 3, 4, \"rw\")"},
        {"modbus_delete_signal", "modbus_delete_signal(\"s\")"},
        {"modbus_reset_connection", "modbus_reset_connection(\"192.168.0.5\")"},
        {"modbus_send_custom_command", "modbus_send_custom_command(\"192.168.0.5\", 255, 6, [0,1,0,1])"},
    };
    if (const auto it = kCalls.find(b.name); it != kCalls.end()) {
        return it->second;
    }
    QStringList arguments;
    for (const auto& parameter : b.parameters) {
        if (parameter.required) {
            arguments << argument(parameter.name);
        }
    }
    return QString::fromStdString(b.name) + '(' + arguments.join(QStringLiteral(", ")) + ')';
}

}  // namespace

class TestBuiltinTable : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void theReadmeIsCurrent() {
        QFile readme(QStringLiteral(TILLER_SOURCE_DIR "/robot/simulator/README.md"));
        QVERIFY(readme.open(QIODevice::ReadWrite));
        const QString text = QString::fromUtf8(readme.readAll());
        const qsizetype at = text.indexOf(QLatin1String(kBegin));
        QVERIFY2(at >= 0, "the README does not contain the marker");
        const QString wanted = text.left(at) + QLatin1String(kBegin) + table();
        if (qEnvironmentVariableIsSet("TILLER_UPDATE")) {
            readme.resize(0);
            readme.write(wanted.toUtf8());
            return;
        }
        QVERIFY2(text == wanted,
                 "the table is not up to date: run with TILLER_UPDATE=1 and check the change");
    }

    // In each series, compiles a function with the first version that has it, the version before that one,
    // and a late version.
    void everyFunctionExistsFromItsVersionOn_data() { everyListedSupportStateIsCorrect_data(); }
    void everyFunctionExistsFromItsVersionOn() {
        QFETCH(int, index);
        const Builtin& b = urscript::builtins()[static_cast<std::size_t>(index)];
        const std::string source = "def t():\n" + b.name + "()\nend\n";
        const auto knows = [&](int major, int minor, bool isListed) {
            urscript::CompileOptions options;
            options.version =
                SoftwareVersion{static_cast<unsigned>(major), static_cast<unsigned>(minor), 9, 0};
            options.isListed = isListed;
            const urscript::CompileOutcome outcome = urscript::compile(source, options);
            return outcome || outcome.error.text != "compile_error_name_not_found:" + b.name + ":";
        };
        const auto verify = [&](int major, int first, bool isListed) {
            constexpr int kLast = 200;
            QCOMPARE(knows(major, kLast, isListed), first != urscript::kNever);
            if (first != urscript::kNever) {
                QVERIFY(knows(major, first, isListed));
                QVERIFY(first == 0 || !knows(major, first - 1, isListed));
            }
        };
        for (const bool isListed : {false, true}) {
            const urscript::FirstVersions first =
                isListed ? b.since.listed.value_or(b.since.first) : b.since.first;
            verify(3, first.ofSeries3(), isListed);
            verify(5, first.minor5, isListed);
            verify(10, first.minor10, isListed);
        }
    }

    void everyListedSupportStateIsCorrect_data() {
        QTest::addColumn<int>("index");
        for (std::size_t i = 0; i < urscript::builtins().size(); ++i) {
            QTest::newRow(urscript::builtins()[i].name.c_str()) << static_cast<int>(i);
        }
    }
    void everyListedSupportStateIsCorrect() {
        QFETCH(int, index);
        const Builtin& b = urscript::builtins()[static_cast<std::size_t>(index)];
        SimulatorOptions options;
        options.poweredOn = true;
        const bool polyScopeX = b.since.first.minor5 == urscript::kNever;
        options.software = polyScopeX ? SoftwareVersion{10, 12, 1, 0} : SoftwareVersion{5, 25, 1, 0};
        ControllerModel plant(options);
        const QString frame =
            polyScopeX ? QStringLiteral("add_frame(\"f\", p[0.3,0,0.3,0,0,0])\n") : QString();
        QTcpServer server;  // for builtins that connect to a server
        QVERIFY(server.listen(QHostAddress::LocalHost));
        const QString call = callOf(b).replace("PORT", QString::number(server.serverPort()));
        const QString program = "def t():\n" + frame + call + "\nend\n";
        plant.programs().submit({urscript::SourceSplitter::Unit::Kind::Program, program.toStdString()});
        QByteArray error;
        bool began = false;
        for (int i = 0; i < 400 && (i < 3 || plant.programs().isActive()); ++i) {
            QCoreApplication::processEvents();
            plant.step();
            began = began || plant.programs().isActive();
            for (const primary::Bytes& message : plant.takeOutbox()) {
                if (message.size() > 23 && message[14] == 10) {
                    error = QByteArray(reinterpret_cast<const char*>(message.data()) + 23,
                                       static_cast<qsizetype>(message.size()) - 23);
                }
            }
        }
        QVERIFY2(began, error.constData());
        if (b.needs == nullptr) {
            QCOMPARE(error, QByteArray());
        } else {
            QCOMPARE(error, QByteArray(b.name.c_str()) + " needs " + b.needs + ", which is not simulated");
        }
    }
};

QTEST_GUILESS_MAIN(TestBuiltinTable)
#include "tst_builtin_table.moc"
