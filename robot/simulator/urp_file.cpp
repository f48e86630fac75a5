// SPDX-License-Identifier: MIT
#include "robot/simulator/urp_file.h"

#include <zlib.h>
#include <QStringList>
#include <QXmlStreamReader>

#include "robot/simulator/external_control.h"

namespace tiller::simulator {

namespace {

constexpr qsizetype kLargestXml = 64 << 20;
constexpr int kDeepest = 64;

bool isGzip(const QByteArray& content) {
    return content.startsWith("\x1f\x8b");
}

/// Turns nodes into statements, from the inside of one `children` element.
class UrpReader {
public:
    explicit UrpReader(const QByteArray& xml) : xml_(xml) {}

    std::optional<std::string> read(const QString& name) {
        QString def = name;
        for (QChar& c : def) {
            c = c.isLetterOrNumber() && c.unicode() < 128 ? c : QChar('_');
        }
        if (def.isEmpty() || def[0].isDigit()) {
            def.prepend('p');
        }
        script_ = QStringLiteral("def %1():\n").arg(def);
        if (!xml_.readNextStartElement() || xml_.name() != QLatin1String("URProgram")) {
            return std::nullopt;
        }
        while (good_ && xml_.readNextStartElement()) {
            xml_.name() == QLatin1String("children") ? readPrograms() : xml_.skipCurrentElement();
        }
        script_ += QLatin1String("end\n");
        return good_ && sawMain_ && !xml_.hasError() ? std::optional(script_.toStdString()) : std::nullopt;
    }

private:
    bool is(const char* name) const { return xml_.name() == QLatin1String(name); }
    QString attribute(const char* name) const {
        return xml_.attributes().value(QLatin1String(name)).toString();
    }
    void emitLine(const QString& line) { script_ += QString(2 * depth_, ' ') + line + '\n'; }
    void refuse() {
        good_ = false;
        xml_.skipCurrentElement();
    }

    void readPrograms() {
        while (good_ && xml_.readNextStartElement()) {
            if (is("MainProgram")) {
                sawMain_ = true;
                const bool forever = attribute("runOnlyOnce") == QLatin1String("false");
                script_ += QLatin1String(forever ? "while True:\n" : "");
                readChildrenOfNode();
                script_ += QLatin1String(forever ? "end\n" : "");
            } else if (is("InitVariablesNode")) {
                xml_.skipCurrentElement();
            } else {
                refuse();  // threads, event nodes, subprograms
            }
        }
    }

    /// Of the current node: everything in its `children`.
    void readChildrenOfNode() {
        if (++depth_ > kDeepest) {
            refuse();
        }
        const qsizetype before = script_.size();
        while (good_ && xml_.readNextStartElement()) {
            is("children") ? readNodes() : xml_.skipCurrentElement();
        }
        if (script_.size() == before) {
            emitLine(QStringLiteral("sync()"));  // a block has to have a statement
        }
        --depth_;
    }

    void readNodes() {
        while (good_ && xml_.readNextStartElement()) {
            if (is("Script")) {
                readScript();
            } else if (is("Wait")) {
                readWait();
            } else if (is("Move")) {
                readMove();
            } else if (is("Folder")) {
                --depth_;  // its nodes stand where it stands
                readChildrenOfNode();
                ++depth_;
            } else if (is("Loop")) {
                readLoop();
            } else if (is("Popup")) {
                readPopup();
            } else if (is("Comment")) {
                xml_.skipCurrentElement();
            } else if (is("Contributed") &&
                       attribute("strategyClass").contains(QLatin1String(kControlNodeOwner))) {
                emitLine(QString::fromUtf8(kControlNode.data(), kControlNode.size()).trimmed());
                xml_.skipCurrentElement();
            } else {
                refuse();
            }
        }
    }

    QString readExpression() {
        QString text;
        while (good_ && xml_.readNextStartElement()) {
            if (is("ExpressionChar") || is("ExpressionToken")) {
                text += attribute("character") + attribute("token");
                xml_.skipCurrentElement();
            } else {
                refuse();
            }
        }
        return text;
    }

    void readScript() {
        QString text;
        while (good_ && xml_.readNextStartElement()) {
            if (is("cachedContents")) {
                text = xml_.readElementText();
            } else if (is("expression")) {
                text = readExpression();
            } else {
                xml_.skipCurrentElement();
            }
        }
        for (const QString& line : text.split('\n')) {
            if (!line.trimmed().isEmpty()) {
                emitLine(line);
            }
        }
    }

    void readWait() {
        const bool sleeps = attribute("type") == QLatin1String("Sleep");
        QString time;
        while (good_ && xml_.readNextStartElement()) {
            if (is("waitTime")) {
                time = xml_.readElementText();
            } else {
                xml_.skipCurrentElement();
            }
        }
        bool ok = false;
        const double seconds = time.toDouble(&ok);
        good_ = good_ && sleeps && ok && seconds >= 0;
        emitLine(QStringLiteral("sleep(%1)").arg(seconds));
    }

    void readLoop() {
        const QString type = attribute("type");
        const int count = attribute("count").toInt();
        if (type == QLatin1String("Always")) {
            emitLine(QStringLiteral("while True:"));
            readChildrenOfNode();
        } else if (type == QLatin1String("Counting") && count > 0) {
            const QString counter = QStringLiteral("loop_%1").arg(++loops_);
            emitLine(counter + QStringLiteral(" = 0"));
            emitLine(QStringLiteral("while %1 < %2:").arg(counter).arg(count));
            readChildrenOfNode();
            emitLine(QStringLiteral("  %1 = %1 + 1").arg(counter));
        } else {
            refuse();
            return;
        }
        emitLine(QStringLiteral("end"));
    }

    void readPopup() {
        QString message = attribute("message");
        message.remove('"');
        emitLine(QStringLiteral("popup(\"%1\", blocking=%2)")
                     .arg(message, attribute("haltProgram") == QLatin1String("true") ? "True" : "False"));
        xml_.skipCurrentElement();
    }

    void readMove() {
        const QString type = attribute("motionType");
        bool okSpeed = false, okAcceleration = false;
        motion_ = {type == QLatin1String("MoveJ")   ? "movej"
                   : type == QLatin1String("MoveL") ? "movel"
                                                    : "",
                   attribute("speed").toDouble(&okSpeed),
                   attribute("acceleration").toDouble(&okAcceleration)};
        good_ = good_ && okSpeed && okAcceleration && *motion_.function != '\0';
        while (good_ && xml_.readNextStartElement()) {
            is("children") ? readWaypoints() : xml_.skipCurrentElement();
        }
    }

    void readWaypoints() {
        while (good_ && xml_.readNextStartElement()) {
            if (!is("Waypoint") || attribute("type") != QLatin1String("Fixed")) {
                refuse();
                return;
            }
            readWaypoint();
        }
    }

    void readWaypoint() {
        QString angles;
        while (good_ && xml_.readNextStartElement()) {
            if (!is("position")) {
                xml_.skipCurrentElement();
                continue;
            }
            while (xml_.readNextStartElement()) {
                if (is("JointAngles")) {
                    angles = attribute("angles");
                }
                xml_.skipCurrentElement();
            }
        }
        const QStringList numbers = angles.split(',');
        bool all = numbers.size() == 6;
        for (const QString& number : numbers) {
            bool ok = false;
            number.trimmed().toDouble(&ok);
            all = all && ok;
        }
        good_ = good_ && all;
        emitLine(QStringLiteral("%1([%2], a=%3, v=%4)")
                     .arg(QLatin1String(motion_.function), angles)
                     .arg(motion_.acceleration)
                     .arg(motion_.speed));
    }

    struct Motion {
        const char* function = "";
        double speed = 0, acceleration = 0;
    };

    QXmlStreamReader xml_;
    QString script_;
    Motion motion_;
    int depth_ = 0;
    int loops_ = 0;
    bool good_ = true;
    bool sawMain_ = false;
};

}  // namespace

std::optional<QByteArray> gunzip(const QByteArray& compressed, qsizetype most) {
    if (!isGzip(compressed)) {
        return std::nullopt;
    }
    z_stream stream{};
    constexpr int kGzipOnly = 16 + MAX_WBITS;
    if (inflateInit2(&stream, kGzipOnly) != Z_OK) {
        return std::nullopt;
    }
    // zlib reads only; its interface is older than const.
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(compressed.constData()));
    stream.avail_in = static_cast<uInt>(compressed.size());
    QByteArray out;
    QByteArray piece(64 * 1024, Qt::Uninitialized);
    int state = Z_OK;
    while (state == Z_OK && out.size() <= most) {
        stream.next_out = reinterpret_cast<Bytef*>(piece.data());
        stream.avail_out = static_cast<uInt>(piece.size());
        state = inflate(&stream, Z_NO_FLUSH);
        out.append(piece.constData(), piece.size() - static_cast<qsizetype>(stream.avail_out));
    }
    inflateEnd(&stream);
    return state == Z_STREAM_END && out.size() <= most ? std::optional(out) : std::nullopt;
}

bool isUrpFile(const QByteArray& content) {
    return isGzip(content) || content.left(4096).contains("<URProgram");
}

std::optional<std::string> scriptOfUrp(const QByteArray& content, const QString& name) {
    const std::optional<QByteArray> xml = isGzip(content) ? gunzip(content, kLargestXml) : content;
    return xml ? UrpReader(*xml).read(name) : std::nullopt;
}

}  // namespace tiller::simulator
