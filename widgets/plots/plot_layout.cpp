// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/plot_layout.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "robot/station/history/derived_signal.h"

namespace tiller {

namespace {

constexpr qsizetype kMaxNameLength = 60;
/// Maximum length of a recording name (file name) or derived-signal name.
constexpr qsizetype kMaxKeyLength = DerivedSignal::kMaxTextLength;
constexpr qsizetype kMaxHeaderLength = 2000;
constexpr double kMinShare = 0.05;
constexpr double kMaxShare = 20;

constexpr std::array<const char*, 3> kTimeAxes = {"relative", "controller", "clock"};

constexpr std::array<const char*, 4> kLines = {"automatic", "solid", "dashed", "dotted"};

QStringList keys(const char* field, int count) {
    QStringList all;
    for (int i = 0; i < count; ++i) {
        all << QStringLiteral("%1_%2").arg(QLatin1String(field)).arg(i);
    }
    return all;
}

QStringList toKeys(const QJsonValue& value, int most) {
    QStringList all;
    const QJsonArray array = value.toArray();
    for (const QJsonValue& one : array) {
        const QString key = one.toString();
        if (!key.isEmpty() && key.size() <= kMaxKeyLength && all.size() < most && !all.contains(key)) {
            all.append(key);
        }
    }
    return all;
}

double within(const QJsonValue& value, double low, double high, double otherwise) {
    const double number = value.toDouble(otherwise);
    return std::isfinite(number) ? std::clamp(number, low, high) : otherwise;
}

QJsonArray toArray(const QMap<QString, CurveStyle>& styles) {
    QJsonArray all;
    for (auto style = styles.begin(); style != styles.end(); ++style) {
        QJsonObject object{{"signal", style.key()}};
        if (style->color.isValid()) {
            object["color"] = style->color.name();
        }
        if (style->line != CurveStyle::Line::Automatic) {
            object["line"] = QLatin1String(kLines[static_cast<std::size_t>(style->line)]);
        }
        if (style->right) {
            object["right"] = true;
        }
        all.append(object);
    }
    return all;
}

QMap<QString, CurveStyle> toStyles(const QJsonArray& array) {
    QMap<QString, CurveStyle> styles;
    for (const QJsonValue& value : array) {
        const QJsonObject object = value.toObject();
        const QString key = object["signal"].toString();
        CurveStyle style;
        if (const QString color = object["color"].toString(); QColor::isValidColor(color)) {
            style.color = QColor(color).toRgb();
        }
        const auto line = std::find_if(kLines.begin(), kLines.end(), [&](const char* name) {
            return object["line"].toString() == QLatin1String(name);
        });
        style.line = line == kLines.end() ? CurveStyle::Line::Automatic
                                          : static_cast<CurveStyle::Line>(line - kLines.begin());
        style.right = object["right"].toBool();
        const bool isKey = !key.isEmpty() && key.size() <= kMaxKeyLength;
        if (isKey && style != CurveStyle() && styles.size() < PlotLayout::kMaxSignals) {
            styles[key] = style;
        }
    }
    return styles;
}

/// Empty for limits that an axis cannot show.
std::optional<ValueLimits> toLimits(const QJsonValue& value) {
    const QJsonArray array = value.toArray();
    const ValueLimits limits{array.at(0).toDouble(), array.at(1).toDouble()};
    const bool isValid = array.size() == 2 && array[0].isDouble() && array[1].isDouble() && limits.isValid();
    return isValid ? std::optional(limits) : std::nullopt;
}

QJsonObject toObject(const PageLayout& page) {
    QJsonArray panes;
    for (const PaneLayout& pane : page.panes) {
        QJsonObject object{{"signals", QJsonArray::fromStringList(pane.shown)},
                           {"hidden", QJsonArray::fromStringList(pane.hidden)},
                           {"column", pane.column},
                           {"share", pane.share}};
        if (!pane.styles.isEmpty()) {
            object["styles"] = toArray(pane.styles);
        }
        if (pane.limits) {
            object["limits"] = QJsonArray{pane.limits->low, pane.limits->high};
        }
        if (pane.rightLimits) {
            object["right_limits"] = QJsonArray{pane.rightLimits->low, pane.rightLimits->high};
        }
        panes.append(object);
    }
    return {{"name", page.name}, {"plots", panes}, {"lanes", QJsonArray::fromStringList(page.lanes)}};
}

QJsonObject toObject(const divergence::Limits& limits) {
    return {{"joint", limits.jointPosition},
            {"tcp", limits.tcpPosition},
            {"current", limits.current},
            {"force", limits.force},
            {"lasting", limits.lasting}};
}

divergence::Limits toModelLimits(const QJsonObject& object) {
    constexpr double kMaxValue = 1e5;
    const divergence::Limits usual;
    divergence::Limits limits;
    limits.jointPosition = within(object["joint"], 0, kMaxValue, usual.jointPosition);
    limits.tcpPosition = within(object["tcp"], 0, kMaxValue, usual.tcpPosition);
    limits.current = within(object["current"], 0, kMaxValue, usual.current);
    limits.force = within(object["force"], 0, kMaxValue, usual.force);
    limits.lasting = within(object["lasting"], 0, kMaxValue, usual.lasting);
    return limits;
}

QJsonObject toObject(const QString& header, const recording::TableFormat& format) {
    QJsonObject object{{"header", header}};
    if (format.timeColumn) {
        object["time"] = QString::fromStdString(*format.timeColumn);
    }
    if (format.timeUnit) {
        object["unit"] = static_cast<int>(*format.timeUnit);
    }
    if (format.separator) {
        object["separator"] = QString(QLatin1Char(*format.separator));
    }
    if (format.decimal) {
        object["decimal"] = QString(QLatin1Char(*format.decimal));
    }
    if (format.hasHeader) {
        object["has_header"] = *format.hasHeader;
    }
    if (format.rate > 0) {
        object["rate"] = format.rate;
    }
    return object;
}

recording::TableFormat toTableFormat(const QJsonObject& object) {
    constexpr double kMaxRate = 1e9;
    const auto character = [&object](const char* key, const char* allowed) -> std::optional<char> {
        const QString text = object[QLatin1String(key)].toString();
        const bool isAllowed = text.size() == 1 && QLatin1String(allowed).contains(text[0]);
        return isAllowed ? std::optional(text[0].toLatin1()) : std::nullopt;
    };
    recording::TableFormat format;
    if (object["time"].isString()) {
        format.timeColumn = object["time"].toString().left(kMaxHeaderLength).toStdString();
    }
    constexpr int kLastUnit = static_cast<int>(recording::TimeUnit::Nanoseconds);
    if (const int unit = object["unit"].toInt(-1); unit >= 0 && unit <= kLastUnit) {
        format.timeUnit = static_cast<recording::TimeUnit>(unit);
    }
    format.separator = character("separator", ",;|\t ");
    format.decimal = character("decimal", ".,");
    if (object["has_header"].isBool()) {
        format.hasHeader = object["has_header"].toBool();
    }
    format.rate = within(object["rate"], 0, kMaxRate, 0);
    return format;
}

PageLayout toPage(const QJsonObject& object) {
    PageLayout page;
    page.name = object["name"].toString().trimmed().left(kMaxNameLength);
    const QJsonArray panes = object["plots"].toArray();
    for (const QJsonValue& value : panes) {
        if (page.panes.size() == PlotLayout::kMaxPanes) {
            break;
        }
        const QJsonObject pane = value.toObject();
        page.panes.append({toKeys(pane["signals"], PlotLayout::kMaxSignals),
                           toKeys(pane["hidden"], PlotLayout::kMaxSignals),
                           static_cast<int>(within(pane["column"], 0, PlotLayout::kMaxColumns - 1, 0)),
                           within(pane["share"], kMinShare, kMaxShare, 1), toStyles(pane["styles"].toArray()),
                           toLimits(pane["limits"]), toLimits(pane["right_limits"])});
    }
    page.lanes = toKeys(object["lanes"], PlotLayout::kMaxLanes);
    return page;
}

}  // namespace

bool ValueLimits::isValid() const {
    constexpr double kMaxLimit = 1e12;
    constexpr double kMinShareOfValue =
        1e-9;  // with a smaller range, the numbers of the grid lines would not differ
    const double largest = std::max(std::abs(low), std::abs(high));
    return largest <= kMaxLimit && high - low > largest * kMinShareOfValue;
}

PageLayout PageLayout::standard() {
    PageLayout page;
    page.panes = {{keys("actual_TCP_force", 3), {}, 0, 0.54}, {keys("actual_current", 6), {}, 0, 0.46}};
    return page;
}

QByteArray PlotLayout::toJson() const {
    QJsonArray all;
    for (const PageLayout& page : pages) {
        all.append(toObject(page));
    }
    QJsonArray limits;
    for (const Threshold& threshold : thresholds) {
        limits.append(
            QJsonObject{{"signal", threshold.key}, {"limit", threshold.limit}, {"above", threshold.above}});
    }
    QJsonArray formats;
    for (auto table = tables.begin(); table != tables.end() && formats.size() < kMaxTables; ++table) {
        formats.append(toObject(table.key(), table.value()));
    }
    const QJsonObject root{{"version", 1},
                           {"pages", all},
                           {"current", current},
                           {"span", span},
                           {"time", QLatin1String(kTimeAxes[static_cast<std::size_t>(time)])},
                           {"thresholds", limits},
                           {"model_limits", toObject(modelLimits)},
                           {"tables", formats}};
    return QJsonDocument(root).toJson(QJsonDocument::Compact);
}

Result<PlotLayout> PlotLayout::fromJson(const QByteArray& json) {
    QJsonParseError problem;
    const QJsonDocument document = QJsonDocument::fromJson(json, &problem);
    const QJsonArray pages = document.object()["pages"].toArray();
    if (!document.isObject() || pages.isEmpty()) {
        return Error{
            ErrorCode::FileCorrupt,
            QCoreApplication::translate("tiller::PlotDock", "the file does not contain a plot layout"),
            problem.error == QJsonParseError::NoError ? QString() : problem.errorString()};
    }
    PlotLayout layout;
    layout.pages.clear();
    for (const QJsonValue& page : pages) {
        if (layout.pages.size() < kMaxPages) {
            layout.pages.append(toPage(page.toObject()));
        }
    }
    layout.current = static_cast<int>(
        within(document.object()["current"], 0, static_cast<double>(layout.pages.size() - 1), 0));
    const QJsonArray limits = document.object()["thresholds"].toArray();
    for (const QJsonValue& value : limits) {
        const QJsonObject limit = value.toObject();
        if (layout.thresholds.size() < PlotMarks::kMaxThresholds && limit["limit"].isDouble()) {
            const QString key = limit["signal"].toString();
            if (key.size() <= kMaxKeyLength) {
                layout.thresholds.append({key, limit["limit"].toDouble(), limit["above"].toBool(true)});
            }
        }
    }
    const auto axis = std::find_if(kTimeAxes.begin(), kTimeAxes.end(), [&](const char* name) {
        return document.object()["time"].toString() == QLatin1String(name);
    });
    layout.time =
        axis == kTimeAxes.end() ? TimeAxis::Relative : static_cast<TimeAxis>(axis - kTimeAxes.begin());
    layout.modelLimits = toModelLimits(document.object()["model_limits"].toObject());
    const QJsonArray formats = document.object()["tables"].toArray();
    for (const QJsonValue& value : formats) {
        const QString header = value.toObject()["header"].toString();
        if (!header.isEmpty() && header.size() <= kMaxHeaderLength && layout.tables.size() < kMaxTables) {
            layout.tables[header] = toTableFormat(value.toObject());
        }
    }
    layout.span = within(document.object()["span"], 0.05, 86400, 30);
    return layout;
}

}  // namespace tiller
