// SPDX-License-Identifier: MIT
#include "robot/script/step_gate.h"

namespace tiller::script {

namespace {

const char* initialValue(GateVariable::Type type) {
    switch (type) {
        case GateVariable::Type::Number:
            return "0.0";
        case GateVariable::Type::Whole:
            return "0";
        case GateVariable::Type::Flag:
            return "False";
    }
    return "0.0";
}

/// Definition of tiller_take_change(). The variables are declared here too, because a function can use only names that
/// are known before it.
QString changeScript(const GateInputs& inputs) {
    QString lines;
    QString cases;
    for (std::size_t i = 0; i < inputs.variables.size(); ++i) {
        const GateVariable& variable = inputs.variables[i];
        lines += QStringLiteral("  global %1 = %2\n")
                     .arg(variable.name, QLatin1String(initialValue(variable.type)));
        const QString value =
            variable.type == GateVariable::Type::Number
                ? QStringLiteral("read_input_float_register(%1)").arg(inputs.change)
                : QStringLiteral("read_input_integer_register(%1)").arg(inputs.whole) +
                      (variable.type == GateVariable::Type::Flag ? QStringLiteral(" != 0") : QString());
        cases += QStringLiteral("        if variable == %1:\n          global %2 = %3\n        end\n")
                     .arg(i)
                     .arg(variable.name, value);
    }
    // A robot may apply the values of one package in different control periods.
    lines += QStringLiteral(
        "  global tiller_change_taken = 0.0\n"
        "  def tiller_take_change():\n"
        "    local number = read_input_float_register({{CHANGE}})\n"
        "    if number > 0 and number != tiller_change_taken:\n"
        "      sync()\n"
        "      sync()\n"
        "      if read_input_float_register({{CHANGE}}) == number:\n"
        "        local variable = read_input_float_register({{VARIABLE}})\n"
        "{{CASES}}"
        "        global tiller_change_taken = number\n"
        "      end\n"
        "    end\n"
        "  end\n");
    lines.replace(QStringLiteral("{{CASES}}"), cases);
    lines.replace(QStringLiteral("{{CHANGE}}"), QString::number(inputs.change + 2));
    lines.replace(QStringLiteral("{{VARIABLE}}"), QString::number(inputs.change + 1));
    return lines;
}

}  // namespace

QString stepGateScript(const GateInputs& inputs) {
    const bool hasVariables = !inputs.variables.empty();
    QString lines = hasVariables ? changeScript(inputs) : QString();
    lines += QStringLiteral(
        "  write_output_integer_register({{GATE}}, 0)\n"
        "  global tiller_steps_begun = 0\n"
        "  def tiller_steps_permitted():\n"
        "    local value = read_input_integer_register({{INPUT}})\n"
        "    if value < 0:\n"
        "      return -value - 1\n"
        "    end\n"
        "    return value - 1\n"
        "  end\n"
        "  def tiller_begin():\n"
        "    global tiller_steps_begun = tiller_steps_begun + 1\n"
        "    write_output_integer_register({{GATE}}, tiller_steps_begun)\n"
        "  end\n"
        "  def tiller_step(number):\n"
        "    write_output_integer_register({{STEP}}, number)\n"
        "    if tiller_steps_permitted() <= tiller_steps_begun:\n"
        "      write_output_integer_register({{GATE}}, -1 - tiller_steps_begun)\n"
        "      while tiller_steps_permitted() <= tiller_steps_begun:\n"
        "{{TAKE}}"
        "        sync()\n"
        "      end\n"
        "    end\n"
        "    tiller_begin()\n"
        "  end\n"
        "  def tiller_stops_here():\n"
        "    local permitted = tiller_steps_permitted()\n"
        "    if permitted >= {{UNLIMITED}}:\n"
        "      permitted = permitted - {{UNLIMITED}}\n"
        "    end\n"
        "    return permitted <= tiller_steps_begun\n"
        "  end\n"
        "  def tiller_break(number):\n"
        "    write_output_integer_register({{STEP}}, number)\n"
        "    if tiller_stops_here():\n"
        "      write_output_integer_register({{GATE}}, -1 - tiller_steps_begun)\n"
        "      while tiller_stops_here():\n"
        "{{TAKE}}"
        "        sync()\n"
        "      end\n"
        "    end\n"
        "    tiller_begin()\n"
        "  end\n"
        "  def tiller_turn(turn):\n"
        "    if turn > 1 and read_input_integer_register({{INPUT}}) < 0:\n"
        "      while not is_steady():\n"
        "        sync()\n"
        "      end\n"
        "      write_output_integer_register({{STEP}}, 0)\n"
        "      halt\n"
        "    end\n"
        "    return turn\n"
        "  end\n");
    lines.replace(QStringLiteral("{{TAKE}}"),
                  hasVariables ? QStringLiteral("        tiller_take_change()\n") : QString());
    lines.replace(QStringLiteral("{{GATE}}"), QString::number(kGateRegister));
    lines.replace(QStringLiteral("{{UNLIMITED}}"), QString::number(StepGate::kUnlimited));
    lines.replace(QStringLiteral("{{STEP}}"), QString::number(kStepRegister));
    lines.replace(QStringLiteral("{{INPUT}}"), QString::number(inputs.steps));
    return lines;
}

}  // namespace tiller::script
