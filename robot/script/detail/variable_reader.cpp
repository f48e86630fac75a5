// SPDX-License-Identifier: MIT
#include "robot/script/detail/variable_reader.h"

#include <QStringList>

#include "robot/script/detail/byte_reader.h"

namespace tiller::script {

namespace {

using Type = ProgramVariable::Type;

enum Content : std::uint8_t { kNames = 0, kValues = 1 };
constexpr std::uint8_t kTimeStamp = 8;  // [bytes]

/// Numbers of the types, which changed with the introduction of matrices.
Type typeOf(std::uint8_t number, const SoftwareVersion& version) {
    const bool isOld = version.major > 0 && version < (version.isCb3() ? SoftwareVersion{3, 14, 0, 0}
                                                                       : SoftwareVersion{5, 9, 0, 0});
    switch (number) {
        case 3:
        case 4:  // a constant string
            return Type::Text;
        case 5:
            return Type::List;
        case 10:
            return Type::Pose;
        case 12:
            return isOld ? Type::Flag : Type::Pose;
        case 13:
            return isOld ? Type::Number : Type::Flag;
        case 14:
            return Type::Whole;
        case 15:
            return isOld ? Type::Number : Type::Whole;
        case 16:
            return Type::Number;
        case 17:
            return Type::List;
        case 18:
            return Type::Matrix;
        default:
            return Type::None;
    }
}

class ValueReader {
public:
    ValueReader(ByteReader& in, const SoftwareVersion& version) : in_(in), version_(version) {}

    bool read(ProgramVariable& into) { return value(into, kMaxDepth) && in_.ok(); }

private:
    static constexpr int kMaxDepth = 8;  // maximum nesting of lists
    static constexpr int kDigits = 7;    // significant digits of a number in single precision

    bool value(ProgramVariable& into, int depth) {
        const std::uint8_t number = in_.u8();
        into.type = typeOf(number, version_);
        switch (into.type) {
            case Type::None:
                return number == 0;  // the length of an unknown type is unknown
            case Type::Flag:
                into.number = in_.boolean() ? 1 : 0;
                into.text = into.number > 0 ? QStringLiteral("True") : QStringLiteral("False");
                return true;
            case Type::Whole:
                into.number = in_.i32();
                into.text = QString::number(into.number, 'f', 0);
                return true;
            case Type::Number:
                into.number = in_.f32();
                into.text = QString::number(into.number, 'g', kDigits);
                return true;
            case Type::Text:
                into.text = QLatin1Char('"') + in_.text(length()) + QLatin1Char('"');
                return true;
            case Type::Pose: {
                QStringList parts;
                for (int i = 0; i < 6; ++i) {
                    parts << QString::number(static_cast<double>(in_.f32()), 'g', kDigits);
                }
                into.text = QStringLiteral("p[%1]").arg(parts.join(QStringLiteral(", ")));
                return true;
            }
            case Type::List:
                return depth > 0 && list(length(), into.text, depth - 1);
            case Type::Matrix:
                return matrix(into.text);
        }
        return false;
    }

    std::size_t length() {
        const unsigned high = in_.u8();
        return (high << 8) | in_.u8();
    }

    bool list(std::size_t count, QString& text, int depth) {
        QStringList parts;
        for (std::size_t i = 0; i < count; ++i) {
            ProgramVariable part;
            if (!value(part, depth) || !in_.ok()) {
                return false;
            }
            parts << part.text;
        }
        text = QStringLiteral("[%1]").arg(parts.join(QStringLiteral(", ")));
        return true;
    }

    bool matrix(QString& text) {
        const std::size_t rows = length();
        const std::size_t columns = length();
        if (columns == 0) {
            return rows == 0;  // the size of the package does not limit the number of rows without columns
        }
        QStringList parts;
        for (std::size_t i = 0; i < rows; ++i) {
            if (!list(columns, parts.emplaceBack(), 0)) {
                return false;
            }
        }
        text = QStringLiteral("[%1]").arg(parts.join(QStringLiteral(", ")));
        return true;
    }

    ByteReader& in_;
    const SoftwareVersion& version_;
};

}  // namespace

bool readVariables(std::span<const std::uint8_t> body, const SoftwareVersion& version,
                   ProgramVariables& variables) {
    ByteReader in(body);
    in.skip(kTimeStamp);
    const std::uint8_t content = in.u8();
    const unsigned high = in.u8();
    const std::size_t first = (high << 8) | in.u8();
    auto list = variables ? std::vector<ProgramVariable>(*variables) : std::vector<ProgramVariable>();
    if (!in.ok() || first > list.size()) {
        return false;
    }
    if (content == kNames) {
        list.resize(first);
        for (const QString& name : in.rest().split(QLatin1Char('\n'), Qt::SkipEmptyParts)) {
            list.push_back({.name = name});
        }
    } else if (content == kValues) {
        ValueReader reader(in, version);
        for (std::size_t i = first; i < list.size() && in.remaining() > 0; ++i) {
            ProgramVariable read{.name = list[i].name};
            if (!reader.read(read) || in.u8() != '\n' || !in.ok()) {
                return false;
            }
            list[i] = std::move(read);
        }
    }
    variables = std::make_shared<const std::vector<ProgramVariable>>(std::move(list));
    return true;
}

}  // namespace tiller::script
