// SPDX-License-Identifier: MIT
#pragma once

// Registers, flags and terminals of a program, and the automatic functions that a program configures for the
// terminals.

#include <array>
#include <bitset>

#include "robot/simulator/plant/terminal_rules.h"
#include "robot/simulator/urscript/host.h"

namespace tiller::simulator {

class Plant;

/// Threads  the simulator thread
class ScriptTerminals : public virtual urscript::RegisterHost, public virtual urscript::IoHost {
public:
    explicit ScriptTerminals(Plant& plant) : plant_(plant) {}

    /// Called when a program has started or ended. Sets the outputs that follow the program state.
    void programChanged(bool running);
    /// True if any input that acts as a freedrive button is high.
    bool freedriveWanted() const;

    bool boolRegister(urscript::RegisterSide side, int address) const override;
    std::int32_t intRegister(urscript::RegisterSide side, int address) const override;
    double floatRegister(urscript::RegisterSide side, int address) const override;
    void setBoolOutput(int address, bool value) override;
    void setIntOutput(int address, std::int32_t value) override;
    void setFloatOutput(int address, double value) override;
    bool flag(int number) const override;
    void setFlag(int number, bool value) override;
    bool portBit(int address) const override;
    void setPortBit(int address, bool value) override;
    std::int16_t portRegister(int address) const override;
    void setPortRegister(int address, std::int16_t value) override;

    bool digitalInput(urscript::DigitalBank bank, int n) const override;
    bool digitalOutput(urscript::DigitalBank bank, int n) const override;
    void setDigitalOutput(urscript::DigitalBank bank, int n, bool value) override;
    double analog(urscript::AnalogPort port, int n) const override;
    void setAnalogOutput(int n, double level) override;
    void setAnalogDomain(urscript::AnalogPort port, int n, int domain) override;
    void setToolVoltage(int volts) override;
    void setToolCommunication(const urscript::ToolCommunication& settings) override;
    void setToolOutputMode(int mode) override;
    void setToolDigitalOutputMode(int n, int mode) override;
    void setRunState(urscript::RuledOutput output, int number, int state) override;
    void setFreedriveInput(urscript::RuledInput input, int number, bool freedrive) override;
    void resetInputActions() override;

private:
    TerminalRules rules_;
    std::bitset<kPorts> portBits_;
    std::array<std::int16_t, kPorts> portRegisters_{};
    Plant& plant_;
};

}  // namespace tiller::simulator
