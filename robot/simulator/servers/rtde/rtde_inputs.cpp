// SPDX-License-Identifier: MIT
#include "robot/simulator/servers/rtde/rtde_inputs.h"

#include <charconv>

#include "robot/simulator/controller/controller_model.h"

namespace tiller::simulator {

namespace {

/// Returns the number after `prefix`; empty without a number.
std::optional<std::size_t> numberAfter(std::string_view name, std::string_view prefix) {
    if (!name.starts_with(prefix)) {
        return std::nullopt;
    }
    std::size_t number = 0;
    const std::string_view digits = name.substr(prefix.size());
    const auto parsed = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    return parsed.ec == std::errc() ? std::optional(number) : std::nullopt;
}

rtde::DataType typeIn(rtde::ProtocolVersion protocol, const rtde::Field& field) {
    const bool wide = protocol == rtde::ProtocolVersion::V3 &&
                      std::string_view(field.name).starts_with("configurable_digital_output");
    return wide ? rtde::DataType::UInt32 : field.type;
}

}  // namespace

RtdeInputs::RtdeInputs(ControllerModel& plant, const SoftwareVersion& software)
    : plant_(plant), software_(software), owners_(rtde::inputFields().size(), 0) {}

RtdeInputs::Claim RtdeInputs::claim(ClientId client, const std::vector<std::string>& names,
                                    rtde::ProtocolVersion protocol) {
    Claim claim;
    InputRecipe recipe;
    std::vector<rtde::DataType> types;
    bool granted = !names.empty();
    const bool isListed = plant_.assumptions().firstVersions == BehaviourOptions::FirstVersions::Latest;
    for (const std::string& name : names) {
        const rtde::Field* field = rtde::findInput(name);
        if (field == nullptr ||
            !(isListed ? field->isListedOn(software_) : field->isAvailableOn(software_))) {
            claim.answers.push_back(rtde::FieldAnswer::notFound());
            granted = false;
            continue;
        }
        const auto index = static_cast<std::size_t>(field - rtde::inputFields().data());
        if (owners_[index] != 0 && owners_[index] != client) {
            claim.answers.push_back(rtde::FieldAnswer::inUse());
            granted = false;
            continue;
        }
        const rtde::DataType type = typeIn(protocol, *field);
        claim.answers.push_back(rtde::FieldAnswer::of(type));
        recipe.fields.push_back(index);
        types.push_back(type);
    }
    if (granted) {
        for (const std::size_t index : recipe.fields) {
            owners_[index] = client;
        }
        recipe.layout = rtde::ValueLayout(std::move(types));
        claim.recipe = std::move(recipe);
    }
    return claim;
}

void RtdeInputs::release(ClientId client) {
    const bool zeroed = plant_.assumptions().registers == BehaviourOptions::Registers::Zeroed;
    for (std::size_t index = 0; index < owners_.size(); ++index) {
        if (owners_[index] != client) {
            continue;
        }
        owners_[index] = 0;
        const rtde::Field& field = rtde::inputFields()[index];
        if (zeroed && std::string_view(field.name).starts_with("input_")) {
            constexpr double kNothing = 0;
            store(field, &kNothing);
        }
    }
}

// Returns the fields of a package that are applied in the next period.
std::vector<bool> RtdeInputs::lateFields(std::size_t count) const {
    std::vector<bool> late(count, false);
    const BehaviourOptions::Inputs reading = plant_.assumptions().inputs;
    for (std::size_t i = 0; i < count; ++i) {
        // Any pattern is suitable, but it must be fixed. Otherwise, older values could overwrite newer
        // values.
        const bool scattered = (i * 2654435761U >> 7U & 1U) != 0;
        late[i] = reading == BehaviourOptions::Inputs::FirstHalf   ? i >= count / 2
                  : reading == BehaviourOptions::Inputs::LastHalf  ? i < count / 2
                  : reading == BehaviourOptions::Inputs::Scattered ? scattered
                                                                   : false;
    }
    return late;
}

void RtdeInputs::storeFields(const InputRecipe& recipe, const std::vector<double>& values,
                             const std::vector<bool>& skipped) {
    const double* value = values.data();
    for (std::size_t i = 0; i < recipe.fields.size(); ++i) {
        const rtde::Field& field = rtde::inputFields()[recipe.fields[i]];
        if (!skipped[i]) {
            store(field, value);
        }
        value += field.components();
    }
    applyMasks(recipe);
}

void RtdeInputs::applyRest() {
    std::erase_if(rests_, [this](Rest& rest) {
        if (rest.period >= plant_.tick()) {
            return false;
        }
        rest.late.flip();
        storeFields(rest.recipe, rest.values, rest.late);
        return true;
    });
}

bool RtdeInputs::apply(const InputRecipe& recipe, rtde::ByteView wire) {
    values_.resize(recipe.layout.components());
    if (!rtde::decodeValues(recipe.layout, wire, values_)) {
        return false;
    }
    // Apply the rest of the previous package first, so that it cannot overwrite this one.
    applyRest();
    const std::vector<bool> late = lateFields(recipe.fields.size());
    storeFields(recipe, values_, late);
    if (plant_.assumptions().inputs != BehaviourOptions::Inputs::Whole) {
        rests_.push_back({plant_.tick(), recipe, values_, late});
    }
    ++packages_;
    for (const std::size_t index : recipe.fields) {
        plant_.watchdogs().touched(index);
    }
    return true;
}

void RtdeInputs::store(const rtde::Field& field, const double* value) {
    const std::string_view name = field.name;
    RegisterBank& bank = plant_.registers().input;
    const auto byte = [value] { return static_cast<unsigned>(*value); };
    if (const auto n = numberAfter(name, "input_int_register_")) {
        bank.ints[*n] = static_cast<std::int32_t>(*value);
    } else if (const auto d = numberAfter(name, "input_double_register_")) {
        bank.doubles[*d] = *value;
    } else if (const auto b = numberAfter(name, "input_bit_register_")) {
        bank.bits[*b] = *value != 0;
    } else if (name == "input_bit_registers0_to_31") {
        bank.setWord(0, static_cast<std::uint32_t>(*value));
    } else if (name == "input_bit_registers32_to_63") {
        bank.setWord(32, static_cast<std::uint32_t>(*value));
    } else if (name == "speed_slider_mask") {
        sliderMask_ = *value;
    } else if (name == "speed_slider_fraction") {
        sliderFraction_ = *value;
    } else if (name == "standard_digital_output_mask") {
        standard_.mask = byte();
    } else if (name == "standard_digital_output") {
        standard_.value = byte();
    } else if (name == "configurable_digital_output_mask") {
        configurable_.mask = byte();
    } else if (name == "configurable_digital_output") {
        configurable_.value = byte();
    } else if (name == "tool_digital_output_mask") {
        tool_.mask = byte();
    } else if (name == "tool_digital_output") {
        tool_.value = byte();
    } else if (name == "standard_analog_output_mask") {
        analogMask_ = byte();
    } else if (name == "standard_analog_output_type") {
        analogType_ = byte();
    } else if (name == "standard_analog_output_0") {
        analog_[0] = *value;
    } else if (name == "standard_analog_output_1") {
        analog_[1] = *value;
    } else if (name == "external_force_torque") {
        plant_.setExternalForceTorque(Wrench::fromVector(Vector6::Map(value)));
    }
}

void RtdeInputs::applyMasks(const InputRecipe& recipe) {
    // Apply only inputs of this package. The old mask of another client must not take effect again.
    bool slider = false, standard = false, configurable = false, tool = false, analog = false;
    for (const std::size_t index : recipe.fields) {
        const std::string_view name = rtde::inputFields()[index].name;
        slider |= name.starts_with("speed_slider");
        standard |= name.starts_with("standard_digital");
        configurable |= name.starts_with("configurable_digital");
        tool |= name.starts_with("tool_digital");
        analog |= name.starts_with("standard_analog");
    }
    Pins& pins = plant_.pins();
    const auto digital = [&pins](const DigitalGroup& group, int first, int count) {
        for (int i = 0; i < count; ++i) {
            if (((group.mask >> i) & 1U) != 0) {
                Pins::setBit(pins.digitalOutputs, first + i, ((group.value >> i) & 1U) != 0);
            }
        }
    };
    if (slider && sliderMask_ != 0) {
        plant_.setSpeedSlider(sliderFraction_);
    }
    if (standard) {
        digital(standard_, 0, 8);
    }
    if (configurable) {
        digital(configurable_, kConfigurablePin, 8);
    }
    if (tool) {
        digital(tool_, kToolPin, 2);
    }
    for (std::size_t i = 0; analog && i < 2; ++i) {
        if (((analogMask_ >> i) & 1U) != 0) {
            pins.analogOutputDomains[i] = (analogType_ >> i) & 1U;
            pins.setAnalogOutput(i, analog_[i]);
        }
    }
}

}  // namespace tiller::simulator
