// SPDX-License-Identifier: MIT
#include "robot/rtde/fields.h"

#include <algorithm>
#include <array>
#include <deque>
#include <numeric>
#include <unordered_map>
#include <utility>
#include <vector>

#include "robot/rtde/detail/field_tables.h"

namespace tiller::rtde {

namespace {

constexpr Since kSince34{{3, 4, 0, 0}, {}, true};
constexpr Since kSinceUpper{{3, 9, 0, 0}, {5, 3, 0, 0}, true};

const char* prefix(Direction registers) {
    return registers == Direction::Output ? "output_" : "input_";
}

/// Built once. `names_` owns the register names.
class Catalogue {
public:
    Catalogue() {
        outputs_.assign(tables::kOutputs.begin(), tables::kOutputs.end());
        inputs_.assign(tables::kInputs.begin(), tables::kInputs.end());
        addRegisters(outputs_, Direction::Output, Direction::Output);
        // A client may also read back input registers.
        addRegisters(outputs_, Direction::Output, Direction::Input);
        addRegisters(inputs_, Direction::Input, Direction::Input);
        for (const Field& field : outputs_) {
            outputByName_.emplace(field.name, &field);
        }
        for (const Field& field : inputs_) {
            inputByName_.emplace(field.name, &field);
        }
    }

    std::span<const Field> outputs() const { return outputs_; }
    std::span<const Field> inputs() const { return inputs_; }
    const Field* output(std::string_view name) const { return look(outputByName_, name); }
    const Field* input(std::string_view name) const { return look(inputByName_, name); }

private:
    using Index = std::unordered_map<std::string_view, const Field*>;

    static const Field* look(const Index& index, std::string_view name) {
        const auto found = index.find(name);
        return found == index.end() ? nullptr : found->second;
    }

    void add(std::vector<Field>& into, Direction direction, std::string name, DataType type,
             const char* meaning, const Since& since) {
        names_.push_back(std::move(name));
        into.push_back({names_.back().c_str(), type, "", meaning, direction, since});
    }

    /// direction  direction of transmission
    /// registers  whether input or output registers are described
    void addRegisters(std::vector<Field>& into, Direction direction, Direction registers) {
        const Since lowBits = registers == Direction::Output ? Since{} : kSince34;
        add(into, direction, std::string(prefix(registers)) + "bit_registers0_to_31", DataType::UInt32,
            "bit registers 0 to 31", lowBits);
        add(into, direction, std::string(prefix(registers)) + "bit_registers32_to_63", DataType::UInt32,
            "bit registers 32 to 63", lowBits);
        for (int n = kFirstSingleBitRegister; n < kBitRegisterCount; ++n) {
            add(into, direction, bitRegisterName(registers, n), DataType::Bool, "bit register", kSinceUpper);
        }
        for (int n = 0; n < kRegisterCount; ++n) {
            add(into, direction, intRegisterName(registers, n), DataType::Int32, "integer register",
                n < kFirstUpperRegister ? kSince34 : kSinceUpper);
        }
        for (int n = 0; n < kRegisterCount; ++n) {
            add(into, direction, doubleRegisterName(registers, n), DataType::Double, "double register",
                n < kFirstUpperRegister ? kSince34 : kSinceUpper);
        }
    }

    std::deque<std::string> names_;
    std::vector<Field> outputs_;
    std::vector<Field> inputs_;
    Index outputByName_;
    Index inputByName_;
};

const Catalogue& catalogue() {
    static const Catalogue instance;
    return instance;
}

}  // namespace

bool Field::isAvailableOn(const SoftwareVersion& version) const {
    const SoftwareVersion asked{version.major, version.minor, version.bugfix, 0};
    if (version.isCb3()) {
        return asked >= since.cb3;
    }
    return asked >= since.eSeries;
}

bool Field::isListedOn(const SoftwareVersion& version) const {
    // Software versions of the clients whose tables list the undocumented fields.
    const SoftwareVersion listed =
        version.isPolyScopeX() ? SoftwareVersion{10, 12, 0, 0} : SoftwareVersion{5, 25, 0, 0};
    return isAvailableOn(version) && (since.confirmed || version >= listed);
}

std::span<const Field> outputFields() {
    return catalogue().outputs();
}

std::span<const Field> inputFields() {
    return catalogue().inputs();
}

const Field* findOutput(std::string_view name) {
    return catalogue().output(name);
}

const Field* findInput(std::string_view name) {
    return catalogue().input(name);
}

std::string_view nearestOutput(std::string_view name) {
    const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
    constexpr std::size_t kLongest = 100;  // longer than all field names
    if (name.size() > kLongest) {
        return {};
    }
    std::string_view nearest;
    std::size_t least = std::max<std::size_t>(2, name.size() / 4) + 1;
    for (const Field& field : outputFields()) {
        // Levenshtein distance, row by row: insertions, deletions and substitutions cost 1 each.
        const std::string_view known = field.name;
        std::vector<std::size_t> row(known.size() + 1);
        std::iota(row.begin(), row.end(), std::size_t(0));
        for (std::size_t i = 0; i < name.size(); ++i) {
            std::size_t diagonal = std::exchange(row[0], i + 1);
            for (std::size_t j = 0; j < known.size(); ++j) {
                const std::size_t exchanged = diagonal + (lower(name[i]) == lower(known[j]) ? 0 : 1);
                diagonal = row[j + 1];
                row[j + 1] = std::min({row[j + 1] + 1, row[j] + 1, exchanged});
            }
        }
        if (row.back() < least) {
            least = row.back();
            nearest = known;
        }
    }
    return nearest;
}

std::string componentName(std::string_view field, DataType type, std::size_t component) {
    std::string name(field);
    if (componentCount(type) > 1) {
        name += '_';
        name += std::to_string(component);
    }
    return name;
}

std::string intRegisterName(Direction direction, int number) {
    return std::string(prefix(direction)) + "int_register_" + std::to_string(number);
}

std::string doubleRegisterName(Direction direction, int number) {
    return std::string(prefix(direction)) + "double_register_" + std::to_string(number);
}

std::string bitRegisterName(Direction direction, int number) {
    return std::string(prefix(direction)) + "bit_register_" + std::to_string(number);
}

}  // namespace tiller::rtde
