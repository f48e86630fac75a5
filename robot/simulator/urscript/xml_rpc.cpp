// SPDX-License-Identifier: MIT
#include "robot/simulator/urscript/xml_rpc.h"

#include <QUrl>
#include <QXmlStreamReader>
#include <QXmlStreamWriter>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

#include "robot/simulator/urscript/call.h"
#include "robot/simulator/urscript/host.h"
#include "robot/simulator/urscript/operators.h"
#include "robot/simulator/urscript/value_format.h"

namespace tiller::simulator::urscript::xml_rpc {

namespace {

constexpr std::size_t kMaxReply = 1 << 20;  ///< [bytes]
constexpr std::size_t kMaxElements = 10'000;
constexpr std::array<const char*, 6> kPoseMembers{"x", "y", "z", "rx", "ry", "rz"};

// ---- values to XML --------------------------------------------------------------------------------------

class Writer {
public:
    explicit Writer(QByteArray& out) : xml_(&out) { xml_.writeStartDocument(); }

    void call(std::string_view method, std::span<const Value> arguments) {
        xml_.writeStartElement(QStringLiteral("methodCall"));
        xml_.writeTextElement(QStringLiteral("methodName"), text(method));
        xml_.writeStartElement(QStringLiteral("params"));
        for (const Value& argument : arguments) {
            xml_.writeStartElement(QStringLiteral("param"));
            value(argument);
            xml_.writeEndElement();
        }
        xml_.writeEndDocument();
    }
    void response(const Value& answer) {
        xml_.writeStartElement(QStringLiteral("methodResponse"));
        xml_.writeStartElement(QStringLiteral("params"));
        if (!answer.is(Value::Type::None)) {
            xml_.writeStartElement(QStringLiteral("param"));
            value(answer);
        }
        xml_.writeEndDocument();
    }
    void faultResponse(std::string_view words) {
        StructData data;
        data.members.emplace_back("faultCode", std::int32_t{1});
        data.members.emplace_back("faultString", Value(std::string(words)));
        xml_.writeStartElement(QStringLiteral("methodResponse"));
        xml_.writeStartElement(QStringLiteral("fault"));
        value(Value::structure(std::move(data)));
        xml_.writeEndDocument();
    }

private:
    static QString text(std::string_view s) {
        return QString::fromUtf8(s.data(), static_cast<qsizetype>(s.size()));
    }
    void scalar(const char* type, const QString& content) {
        xml_.writeTextElement(QString::fromLatin1(type), content);
    }
    void number(double d) {
        if (!std::isfinite(d)) {
            fault("XML-RPC cannot represent a number that is not finite");
        }
        scalar("double", QString::number(d, 'g', 17));
    }
    void member(std::string_view name, const Value& v) {
        xml_.writeStartElement(QStringLiteral("member"));
        xml_.writeTextElement(QStringLiteral("name"), text(name));
        value(v);
        xml_.writeEndElement();
    }
    void value(const Value& v) {
        xml_.writeStartElement(QStringLiteral("value"));
        switch (v.type()) {
            case Value::Type::Bool:
                scalar("boolean", QString::number(v.asBool() ? 1 : 0));
                break;
            case Value::Type::Int:
                scalar("int", QString::number(v.asInt()));
                break;
            case Value::Type::Float:
                number(v.asFloat());
                break;
            case Value::Type::String:
                scalar("string", text(v.string()));
                break;
            case Value::Type::Pose:
                xml_.writeStartElement(QStringLiteral("struct"));
                for (std::size_t i = 0; i < 6; ++i) {
                    member(kPoseMembers[i], v.pose()[i]);
                }
                xml_.writeEndElement();
                break;
            case Value::Type::Struct:
                xml_.writeStartElement(QStringLiteral("struct"));
                for (const auto& [name, m] : v.structure().members) {
                    member(name, m);
                }
                xml_.writeEndElement();
                break;
            case Value::Type::List:
                array(v.list().size(), [&](std::size_t i) { return v.list().at(i); });
                break;
            case Value::Type::Matrix:
                array(v.matrix().rows,
                      [&](std::size_t i) { return indexed(v, Value(static_cast<std::int32_t>(i))); });
                break;
            case Value::Type::None:
            case Value::Type::Unset:
                fault("XML-RPC cannot represent None");
        }
        xml_.writeEndElement();
    }
    template <class At>
    void array(std::size_t size, At at) {
        xml_.writeStartElement(QStringLiteral("array"));
        xml_.writeStartElement(QStringLiteral("data"));
        for (std::size_t i = 0; i < size; ++i) {
            value(at(i));
        }
        xml_.writeEndElement();
        xml_.writeEndElement();
    }

    QXmlStreamWriter xml_;
};

// ---- XML to values --------------------------------------------------------------------------------------

class Reader {
public:
    explicit Reader(std::string_view body)
        : xml_(QByteArray(body.data(), static_cast<qsizetype>(body.size()))) {}

    MethodCall call() {
        enter("methodCall");
        enter("methodName");
        MethodCall out;
        out.method = xml_.readElementText().trimmed().toStdString();
        if (!xml_.readNextStartElement()) {
            return out;
        }
        if (xml_.name() != QLatin1String("params")) {
            malformed();
        }
        while (xml_.readNextStartElement()) {
            enter("value");
            out.arguments.push_back(value(0));
            xml_.skipCurrentElement();  // skip to the end of <param>
        }
        return out;
    }

    Value response() {
        enter("methodResponse");
        if (!xml_.readNextStartElement()) {
            malformed();
        }
        if (xml_.name() == QLatin1String("fault")) {
            enter("value");
            const Value v = value(0);
            const Value* words = v.is(Value::Type::Struct) ? v.structure().find("faultString") : nullptr;
            fault("XML-RPC fault: " + toStr(words != nullptr ? *words : v));
        }
        if (xml_.name() != QLatin1String("params")) {
            malformed();
        }
        if (!xml_.readNextStartElement()) {
            return Value::none();
        }
        enter("value");
        return value(0);
    }

private:
    [[noreturn]] void malformed() const { fault("The XML-RPC server's reply is malformed"); }
    void enter(const char* element) {
        if (!xml_.readNextStartElement() || xml_.name() != QLatin1String(element)) {
            malformed();
        }
    }

    // Parses the content of <value>, including its end tag.
    Value value(int depth) {
        if (depth > kMaxValueDepth || ++elements_ > kMaxElements) {
            fault("The XML-RPC server's reply is too large");
        }
        QString untyped;
        while (!xml_.atEnd()) {
            switch (xml_.readNext()) {
                case QXmlStreamReader::Characters:
                    untyped += xml_.text();
                    break;
                case QXmlStreamReader::StartElement: {
                    Value v = typed(depth);
                    xml_.skipCurrentElement();  // skip to the end of <value>
                    return v;
                }
                case QXmlStreamReader::EndElement:
                    return string(untyped);
                default:
                    break;
            }
        }
        malformed();
    }
    static Value string(const QString& s) {
        std::string bytes = s.toStdString();
        if (bytes.size() > kMaxStringLength) {
            fault("String is too long");
        }
        return Value(std::move(bytes));
    }
    Value typed(int depth) {
        const QString type = xml_.name().toString();
        if (type == QLatin1String("array")) {
            return array(depth);
        }
        if (type == QLatin1String("struct")) {
            return structure(depth);
        }
        const QString content = xml_.readElementText();
        bool ok = true;
        if (type == QLatin1String("string")) {
            return string(content);
        }
        if (type == QLatin1String("boolean")) {
            return content.trimmed() == QLatin1String("1");
        }
        if (type == QLatin1String("int") || type == QLatin1String("i4")) {
            const std::int32_t i = content.trimmed().toInt(&ok);
            return ok ? Value(i) : (malformed(), Value());
        }
        if (type == QLatin1String("double")) {
            const double d = content.trimmed().toDouble(&ok);
            return ok ? Value(d) : (malformed(), Value());
        }
        fault("XML-RPC type '" + type.toStdString() + "' is not known");
    }
    Value array(int depth) {
        enter("data");
        std::vector<Value> elements;
        while (xml_.readNextStartElement()) {
            if (xml_.name() != QLatin1String("value")) {
                malformed();
            }
            elements.push_back(value(depth + 1));
        }
        xml_.readNextStartElement();  // skip the end of <array>
        return makeList(elements.data(), elements.size(), kMaxElements);
    }
    Value structure(int depth) {
        StructData data;
        while (xml_.readNextStartElement()) {
            if (xml_.name() != QLatin1String("member")) {
                malformed();
            }
            enter("name");
            std::string name = xml_.readElementText().toStdString();
            enter("value");
            data.members.emplace_back(std::move(name), value(depth + 1));
            xml_.skipCurrentElement();
        }
        std::array<double, 6> pose{};
        for (std::size_t i = 0; i < 6; ++i) {
            const Value* member = data.members.size() == 6 ? data.find(kPoseMembers[i]) : nullptr;
            if (member == nullptr || !member->isNumber()) {
                return Value::structure(std::move(data));
            }
            pose[i] = member->number();
        }
        return pose;
    }

    QXmlStreamReader xml_;
    std::size_t elements_ = 0;
};

}  // namespace

std::optional<Address> parseAddress(std::string_view url) {
    QString text = QString::fromUtf8(url.data(), static_cast<qsizetype>(url.size()));
    if (!text.contains(QLatin1String("://"))) {
        text.prepend(QLatin1String("http://"));
    }
    const QUrl parsed(text, QUrl::StrictMode);
    if (!parsed.isValid() || parsed.scheme() != QLatin1String("http") || parsed.host().isEmpty()) {
        return std::nullopt;
    }
    const QString path = parsed.path(QUrl::FullyEncoded);
    return Address{parsed.host().toStdString(), parsed.port(80),
                   path.isEmpty() ? std::string("/") : path.toStdString()};
}

Result<std::string> request(const Address& address, std::string_view method,
                            std::span<const Value> arguments) {
    QByteArray body;
    try {
        Writer(body).call(method, arguments);
    } catch (const Fault& f) {
        return scriptError(f.text);
    }
    std::string text = "POST " + address.path + " HTTP/1.0\r\nHost: " + address.host +
                       "\r\nContent-Type: text/xml\r\nContent-Length: " + std::to_string(body.size()) +
                       "\r\n\r\n";
    text.append(body.constData(), static_cast<std::size_t>(body.size()));
    return text;
}

Result<MethodCall> readCall(std::string_view body) {
    try {
        return Reader(body).call();
    } catch (const Fault& f) {
        return scriptError(f.text);
    }
}

std::string response(const Value& value) {
    QByteArray body;
    try {
        Writer(body).response(value);
    } catch (const Fault& f) {
        return faultResponse(f.text);
    }
    return body.toStdString();
}

std::string faultResponse(std::string_view text) {
    QByteArray body;
    Writer(body).faultResponse(text);
    return body.toStdString();
}

Result<std::optional<Value>> reply(std::string_view received, bool ended) {
    if (received.size() > kMaxReply) {
        return scriptError("The XML-RPC server's reply is too large");
    }
    const std::size_t head = received.find("\r\n\r\n");
    if (head == std::string_view::npos) {
        return ended ? Result<std::optional<Value>>(scriptError("The XML-RPC server closed the connection"))
                     : std::optional<Value>();
    }
    std::string_view body = received.substr(head + 4);
    std::string headers(received.substr(0, head + 2));
    std::transform(headers.begin(), headers.end(), headers.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    const std::size_t length = headers.find("\r\ncontent-length:");
    if (length != std::string::npos) {
        std::size_t wanted = 0;
        const char* first = headers.c_str() + length + 17;
        while (*first == ' ') {
            ++first;
        }
        std::from_chars(first, headers.c_str() + headers.size(), wanted);
        if (body.size() < wanted && !ended) {
            return std::optional<Value>();
        }
        body = body.substr(0, wanted);
    } else if (!ended) {
        return std::optional<Value>();
    }
    if (headers.find(" 200") != std::min(headers.find(' '), headers.size())) {
        return scriptError("The XML-RPC server replied: " +
                           std::string(received.substr(0, received.find("\r\n"))));
    }
    try {
        return std::optional<Value>(Reader(body).response());
    } catch (const Fault& f) {
        return scriptError(f.text);
    }
}

}  // namespace tiller::simulator::urscript::xml_rpc
