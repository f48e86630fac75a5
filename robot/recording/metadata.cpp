// SPDX-License-Identifier: MIT
#include "robot/recording/metadata.h"

#include <algorithm>
#include <array>

namespace tiller::recording {

bool isReservedMetadataName(std::string_view name) {
    constexpr std::array<std::string_view, 11> kReserved = {
        "columns",      "model", "period",  "robot", "serial_number", "software",
        "start_utc_ns", "start", "trigger", "units", "written_by"};
    return name.starts_with("incident") ||
           std::find(kReserved.begin(), kReserved.end(), name) != kReserved.end();
}

bool isMetadataName(std::string_view name) {
    constexpr std::size_t kMaxLength = 60;
    const auto isAllowed = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               static_cast<unsigned char>(c) >= 0x80 ||
               std::string_view(" _-.").find(c) != std::string_view::npos;
    };
    return !name.empty() && name.size() <= kMaxLength && name.front() != ' ' && name.back() != ' ' &&
           std::all_of(name.begin(), name.end(), isAllowed);
}

Result<void> addMetadata(Metadata& metadata, const QString& entry) {
    const auto wrong = [&entry](const QString& why) {
        return Error{ErrorCode::InvalidArgument, QStringLiteral("metadata \"%1\"").arg(entry), why};
    };
    qsizetype sign = 0;
    while (sign < entry.size() && entry[sign] != QLatin1Char('=') && entry[sign] != QLatin1Char(':')) {
        ++sign;
    }
    const std::string name = entry.left(sign).trimmed().toStdString();
    const QString value = entry.mid(sign + 1).trimmed();
    if (sign == entry.size() || !isMetadataName(name) || value.isEmpty()) {
        return wrong(QStringLiteral("enter a name, an equals sign and a value, for example operator=Ann"));
    }
    if (isReservedMetadataName(name)) {
        return wrong(QStringLiteral("the recorder uses the name \"%1\"; choose another name")
                         .arg(QString::fromStdString(name)));
    }
    if (value.size() > kMaxMetadataValue || std::any_of(value.begin(), value.end(), [](QChar c) {
            return c.category() == QChar::Other_Control;
        })) {
        return wrong(
            QStringLiteral("the value must be one line of at most %1 characters").arg(kMaxMetadataValue));
    }
    metadata[name] = value.toStdString();
    return {};
}

}  // namespace tiller::recording
