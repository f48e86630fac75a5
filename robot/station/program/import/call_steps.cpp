// SPDX-License-Identifier: MIT
#include "robot/station/program/import/call_steps.h"

#include <QRegularExpression>
#include <QStringList>
#include <algorithm>
#include <cmath>

#include "robot/station/program/expression.h"
#include "robot/station/program/program_text.h"
#include "robot/station/program/step_kind.h"

namespace tiller::program {

using project::ProgramStep;

QString idOf(const QUuid& id) {
    return id.toString(QUuid::WithoutBraces);
}

ProgramStep makeStep(const char* kind, const QJsonObject& fields) {
    ProgramStep step = newStep(*findStepKind(QLatin1String(kind)));
    for (auto field = fields.begin(); field != fields.end(); ++field) {
        step.fields.insert(field.key(), field.value());
    }
    return step;
}

bool isExpression(const QString& text) {
    const Expression parsed = parseExpression(text);
    return parsed.error.isEmpty() && parsed.script == text.trimmed();
}

std::optional<bool> flagLiteral(const QString& text) {
    return text == QLatin1String("True") || text == QLatin1String("true")     ? std::optional(true)
           : text == QLatin1String("False") || text == QLatin1String("false") ? std::optional(false)
                                                                              : std::nullopt;
}

namespace {

std::optional<int> wholeLiteral(const QString& text) {
    bool ok = false;
    const int value = text.toInt(&ok);
    return ok ? std::optional(value) : std::nullopt;
}

}  // namespace

std::optional<QString> plainString(const QString& literal) {
    const auto text = stringLiteral(literal);
    return text && !text->isEmpty() && scriptString(*text) == literal ? text : std::nullopt;
}

std::optional<int> channelOf(const QString& group, const QString& pin) {
    const auto number = wholeLiteral(pin);
    const int count = group == QLatin1String("tool") ? 2 : 8;
    if (!number || *number < 0 || *number >= count) {
        return std::nullopt;
    }
    return *number + (group == QLatin1String("tool") ? 16 : group == QLatin1String("configurable") ? 8 : 0);
}

namespace {

std::optional<ProgramStep> messageStep(const ScriptCall& call, QString& reason) {
    static const QStringList kTitles{QStringLiteral("\"Message\""), QStringLiteral("\"Warning\""),
                                     QStringLiteral("\"Error\""), QStringLiteral("\"Popup\""),
                                     QStringLiteral("\"Tiller\"")};
    const auto values = call.bind({QStringLiteral("s"), QStringLiteral("title"), QStringLiteral("warning"),
                                   QStringLiteral("error"), QStringLiteral("blocking")});
    if (!values) {
        return std::nullopt;
    }
    const auto flagAt = [&](qsizetype at) {
        return values->at(at).isEmpty() ? std::optional(false) : flagLiteral(values->at(at));
    };
    const auto text = plainString(values->front());
    const auto warning = flagAt(2), error = flagAt(3), waits = flagAt(4);
    if (!values->at(1).isEmpty() && !kTitles.contains(values->at(1))) {
        reason = ProgramText::tr("a Message step cannot have this title");
        return std::nullopt;
    }
    if (!text || !warning || !error || !waits || (*warning && *error)) {
        return std::nullopt;
    }
    return makeStep("message", {{"text", *text},
                                {"level", *error     ? "error"
                                          : *warning ? "warning"
                                                     : "message"},
                                {"waits", *waits}});
}

std::optional<ProgramStep> logStep(const ScriptCall& call) {
    const auto values = call.bind({QStringLiteral("s1"), QStringLiteral("s2")});
    const auto text = values ? plainString(values->front()) : std::nullopt;
    if (!text || (!values->back().isEmpty() && !isExpression(values->back()))) {
        return std::nullopt;
    }
    ProgramStep step = makeStep("log", {{"text", *text}});
    if (!values->back().isEmpty()) {
        step.fields.insert(QStringLiteral("value"), values->back());
    }
    return step;
}

std::optional<ProgramStep> payloadStepFor(const ScriptCall& call, project::PayloadList& payloads,
                                          QString& reason) {
    const auto values = call.bind({QStringLiteral("m"), QStringLiteral("cog")});
    const auto mass = values ? numberLiteral(values->front()) : std::nullopt;
    const auto centre = values ? listLiteral(values->back(), {}, 3) : std::nullopt;
    if (!mass || !centre || *mass < 0 || *mass > project::kHeaviestPayload ||
        std::any_of(centre->begin(), centre->end(),
                    [](double value) { return std::abs(value) > project::kFarthestPayload; })) {
        reason = ProgramText::tr("the payload is not given as numbers in the permitted range");
        return std::nullopt;
    }
    const Eigen::Vector3d point((*centre)[0], (*centre)[1], (*centre)[2]);
    const auto same = std::find_if(payloads.begin(), payloads.end(), [&](const project::Payload& payload) {
        return payload.mass == *mass && payload.centre == point;
    });
    if (same != payloads.end()) {
        return makeStep("payload", {{"payload", idOf(same->id)}});
    }
    project::Payload payload;
    payload.id = QUuid::createUuid();
    payload.name = payloads.uniqueName(QStringLiteral("%1 kg").arg(*mass));
    payload.mass = *mass;
    payload.centre = point;
    payloads.append(payload);
    return makeStep("payload", {{"payload", idOf(payload.id)}});
}

std::optional<ProgramStep> outputStep(const ScriptCall& call) {
    static const QRegularExpression digital(
        QStringLiteral("^set_(?:(standard|configurable|tool)_)?digital_out$"));
    static const QRegularExpression reg(QStringLiteral("^write_output_(integer|float|boolean)_register$"));
    if (call.arguments.size() != 2 || !call.arguments[0].name.isEmpty() ||
        !call.arguments[1].name.isEmpty()) {
        return std::nullopt;
    }
    const QString& pin = call.arguments[0].text;
    const QString& value = call.arguments[1].text;
    if (const auto match = digital.match(call.function); match.hasMatch()) {
        const auto channel = channelOf(match.captured(1), pin);
        const auto on = flagLiteral(value);
        return channel && on ? std::optional(makeStep("setOutput", {{"output", *channel}, {"value", *on}}))
                             : std::nullopt;
    }
    if (call.function == QLatin1String("set_standard_analog_out")) {
        const auto number = wholeLiteral(pin);
        const auto level = numberLiteral(value);
        return number && level
                   ? std::optional(makeStep("setAnalogOutput", {{"output", *number}, {"level", *level}}))
                   : std::nullopt;
    }
    if (const auto match = reg.match(call.function); match.hasMatch()) {
        const auto number = wholeLiteral(pin);
        return number && isExpression(value)
                   ? std::optional(
                         makeStep("setRegister",
                                  {{"type", match.captured(1)}, {"register", *number}, {"value", value}}))
                   : std::nullopt;
    }
    return std::nullopt;
}

}  // namespace

std::optional<ProgramStep> stepForCall(const ScriptCall& call, project::PayloadList& payloads,
                                       QString& reason) {
    if (call.function == QLatin1String("sleep")) {
        const auto values = call.bind({QStringLiteral("t")});
        const auto time = values ? numberLiteral(values->front()) : std::nullopt;
        return time ? std::optional(makeStep("wait", {{"time", *time}})) : std::nullopt;
    }
    if (call.function == QLatin1String("popup")) {
        return messageStep(call, reason);
    }
    if (call.function == QLatin1String("textmsg")) {
        return logStep(call);
    }
    if (call.function == QLatin1String("set_payload")) {
        return payloadStepFor(call, payloads, reason);
    }
    return outputStep(call);
}

}  // namespace tiller::program
