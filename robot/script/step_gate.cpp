// SPDX-License-Identifier: MIT
#include "robot/script/step_gate.h"

namespace tiller::script {

QString stepGateScript(int inputRegister) {
    QString lines = QStringLiteral(
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
    lines.replace(QStringLiteral("{{GATE}}"), QString::number(kGateRegister));
    lines.replace(QStringLiteral("{{UNLIMITED}}"), QString::number(StepGate::kUnlimited));
    lines.replace(QStringLiteral("{{STEP}}"), QString::number(kStepRegister));
    lines.replace(QStringLiteral("{{INPUT}}"), QString::number(inputRegister));
    return lines;
}

}  // namespace tiller::script
