// SPDX-License-Identifier: MIT
#include "robot/project/detail/field_reader.h"

#include <cmath>
#include <numbers>

namespace tiller::project {
namespace {

QString kindOf(const QJsonValue& value) {
    switch (value.type()) {
        case QJsonValue::Null:
            return QStringLiteral("null");
        case QJsonValue::Bool:
            return QStringLiteral("true or false");
        case QJsonValue::Double:
            return QStringLiteral("a number");
        case QJsonValue::String:
            return QStringLiteral("a text");
        case QJsonValue::Array:
            return QStringLiteral("a list");
        case QJsonValue::Object:
            return QStringLiteral("an object");
        case QJsonValue::Undefined:
            break;
    }
    return QStringLiteral("missing");
}

/// Example: "\"C\" is neither \"J\" nor \"L\""; "\"C\" is not one of \"a\", \"b\", \"c\"".
QString isNoneOf(const QString& text, std::span<const char* const> words) {
    QStringList quoted;
    for (const char* word : words) {
        quoted << QStringLiteral("\"%1\"").arg(QLatin1String(word));
    }
    return quoted.size() == 2
               ? QStringLiteral("\"%1\" is neither %2 nor %3").arg(text, quoted[0], quoted[1])
               : QStringLiteral("\"%1\" is not one of %2").arg(text, quoted.join(QLatin1String(", ")));
}

}  // namespace

QString fieldAt(const QString& where, const char* key) {
    return where.isEmpty() ? QString::fromLatin1(key) : where + QLatin1Char('.') + QLatin1String(key);
}

QString fieldAt(const QString& where, int index) {
    return QStringLiteral("%1[%2]").arg(where).arg(index);
}

QString isNot(const QJsonValue& value, const QString& wanted) {
    return value.isUndefined() ? QStringLiteral("is missing")
                               : QStringLiteral("is %1, not %2").arg(kindOf(value), wanted);
}

QJsonObject without(QJsonObject object, std::initializer_list<const char*> known) {
    for (const char* key : known) {
        object.remove(QLatin1String(key));
    }
    return object;
}

QString FieldReader::text(const QString& where, const QJsonObject& object, const char* key) {
    const QJsonValue value = object.value(QLatin1String(key));
    if (!value.isString()) {
        addProblem(fieldAt(where, key), isNot(value, QStringLiteral("a text")));
    } else if (value.toString().isEmpty()) {
        addProblem(fieldAt(where, key), QStringLiteral("is empty"));
    }
    return value.toString();
}

QString FieldReader::optionalText(const QString& where, const QJsonObject& object, const char* key) {
    const QJsonValue value = object.value(QLatin1String(key));
    if (!value.isUndefined() && !value.isString()) {
        addProblem(fieldAt(where, key), isNot(value, QStringLiteral("a text")));
    }
    return value.toString();
}

QUuid FieldReader::id(const QString& where, const QJsonObject& object, const char* key) {
    const QJsonValue value = object.value(QLatin1String(key));
    const QUuid id(value.toString());
    if (!value.isString()) {
        addProblem(fieldAt(where, key), isNot(value, QStringLiteral("a text")));
    } else if (id.isNull()) {
        addProblem(fieldAt(where, key), QStringLiteral("\"%1\" is not an id").arg(value.toString()));
    }
    return id;
}

QUuid FieldReader::optionalId(const QString& where, const QJsonObject& object, const char* key) {
    const QJsonValue value = object.value(QLatin1String(key));
    return value.isUndefined() || value.isNull() ? QUuid() : id(where, object, key);
}

QUuid FieldReader::frameId(const QString& where, const QJsonObject& object) {
    return object.value(QLatin1String("frame")).isNull() ? QUuid() : id(where, object, "frame");
}

QUuid FieldReader::frame(const QString& where, const QJsonObject& object, const FrameList& frames) {
    const QUuid read = frameId(where, object);
    if (!read.isNull() && frames.find(read) == nullptr) {
        addProblem(fieldAt(where, "frame"), QStringLiteral("no frame of this project has that id"));
    }
    return read;
}

double FieldReader::number(const QString& where, const QJsonValue& value, double least, double most,
                           const char* unit) {
    if (!value.isDouble()) {
        addProblem(where, isNot(value, QStringLiteral("a number")));
        return least > 0 ? least : 0;
    }
    const double read = value.toDouble();
    if (!std::isfinite(read) || read < least || read > most) {
        const auto formatted = [unit](double number) {
            const QString text = QString::number(number);
            return *unit == '\0' ? text : QStringLiteral("%1 %2").arg(text, QString::fromUtf8(unit));
        };
        addProblem(where, QStringLiteral("is %1, outside the range %2 to %3")
                              .arg(formatted(read), QString::number(least), formatted(most)));
        return least > 0 ? least : 0;
    }
    return read;
}

double FieldReader::number(const QString& where, const QJsonObject& object, const char* key, double least,
                           double most, const char* unit) {
    return number(fieldAt(where, key), object.value(QLatin1String(key)), least, most, unit);
}

int FieldReader::whole(const QString& where, const QJsonObject& object, const char* key, int least,
                       int most) {
    const double read = number(where, object, key, least, most, "");
    if (read != std::floor(read)) {
        addProblem(fieldAt(where, key), QStringLiteral("is %1, not a whole number").arg(read));
        return least;
    }
    return static_cast<int>(read);
}

bool FieldReader::flag(const QString& where, const QJsonObject& object, const char* key) {
    const QJsonValue value = object.value(QLatin1String(key));
    if (!value.isBool()) {
        addProblem(fieldAt(where, key), isNot(value, QStringLiteral("true or false")));
    }
    return value.toBool();
}

int FieldReader::word(const QString& where, const QJsonObject& object, const char* key,
                      std::span<const char* const> words) {
    const QString read = text(where, object, key);
    int index = 0;
    for (const char* word : words) {
        if (read == QLatin1String(word)) {
            return index;
        }
        ++index;
    }
    if (!read.isEmpty()) {
        addProblem(fieldAt(where, key), isNoneOf(read, words));
    }
    return 0;
}

QVector<double> FieldReader::numbers(const QString& where, const QJsonValue& value, int count) {
    QVector<double> result(count, 0.0);
    if (!value.isArray()) {
        addProblem(where, isNot(value, QStringLiteral("a list of %1 numbers").arg(count)));
        return result;
    }
    const QJsonArray array = value.toArray();
    if (array.size() != count) {
        addProblem(where, QStringLiteral("has %1 numbers, not %2").arg(array.size()).arg(count));
        return result;
    }
    for (int i = 0; i < count; ++i) {
        if (array[i].isDouble()) {
            result[i] = array[i].toDouble();
        } else {
            addProblem(fieldAt(where, i), isNot(array[i], QStringLiteral("a number")));
        }
    }
    return result;
}

std::array<double, 6> FieldReader::six(const QString& where, const QJsonObject& object, const char* key) {
    const QVector<double> read = numbers(fieldAt(where, key), object.value(QLatin1String(key)), 6);
    std::array<double, 6> result{};
    std::copy(read.begin(), read.end(), result.begin());
    return result;
}

Eigen::Vector3d FieldReader::point(const QString& where, const QJsonObject& object, const char* key,
                                   double most) {
    const QString place = fieldAt(where, key);
    const QVector<double> read = numbers(place, object.value(QLatin1String(key)), 3);
    Eigen::Vector3d result;
    for (int i = 0; i < 3; ++i) {
        result[i] = number(fieldAt(place, i), read[i], -most, most, "m");
    }
    return result;
}

Pose FieldReader::pose(const QString& where, const QJsonObject& object, const char* key) {
    std::array<double, 6> result = six(where, object, key);
    for (int i = 0; i < 6; ++i) {
        const double most = i < 3 ? kMaxCoordinate : 4 * std::numbers::pi;
        double& component = result[static_cast<std::size_t>(i)];
        component = number(fieldAt(fieldAt(where, key), i), component, -most, most, i < 3 ? "m" : "rad");
    }
    return Pose::fromArray(result);
}

JointPositions FieldReader::joints(const QString& where, const QJsonValue& value) {
    // Twice the joint range. Larger values are probably in degrees.
    constexpr double kMaxValue = 4 * std::numbers::pi + 0.2;
    const QVector<double> read = numbers(where, value, kJointCount);
    JointPositions q;
    for (int i = 0; i < kJointCount; ++i) {
        q[i] = number(fieldAt(where, i), read[i], -kMaxValue, kMaxValue, "rad");
    }
    return q;
}

QJsonArray FieldReader::list(const QString& where, const QJsonObject& object, const char* key) {
    const QJsonValue value = object.value(QLatin1String(key));
    if (!value.isArray()) {
        addProblem(fieldAt(where, key), isNot(value, QStringLiteral("a list")));
    }
    return value.toArray();
}

QJsonArray FieldReader::optionalList(const QString& where, const QJsonObject& object, const char* key) {
    return object.contains(QLatin1String(key)) ? list(where, object, key) : QJsonArray();
}

}  // namespace tiller::project
