// SPDX-License-Identifier: MIT
#include "robot/simulator/pendant/pendant_program.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QStringList>
#include <memory>

#include "robot/simulator/pendant/installation.h"
#include "robot/simulator/pendant/program_translator.h"
#include "robot/simulator/pendant/xml_tree.h"

namespace tiller::simulator::pendant {

namespace {

constexpr const char* kEnding = ".installation";

/// The installation named by the program, or the current installation; empty if neither exists.
Result<Installation> installationOf(const XmlElement& root, const PendantSource& source) {
    for (const QString& name : {root.attribute("installationRelativePath") + kEnding,
                                root.attribute("installation") + kEnding, source.installation}) {
        const std::optional<QByteArray> content =
            name == QLatin1String(kEnding) ? std::nullopt : source.files(name);
        if (content) {
            const QString variables = name.chopped(QLatin1String(kEnding).size()) + ".variables";
            return readInstallation(name, *content, source.files(variables).value_or(QByteArray()));
        }
    }
    return Installation();
}

/// Adds the types of the nodes of a .urpx program in the order of the nodes, without duplicates.
void addNodeTypes(const QJsonObject& node, QStringList& types) {
    constexpr qsizetype kMaxTypes = 20;
    const QString type =
        node.value(QLatin1String("contributedNode")).toObject().value(QLatin1String("type")).toString();
    if (!type.isEmpty() && types.size() < kMaxTypes && !types.contains(type)) {
        types << type;
    }
    for (const QJsonValue& child : node.value(QLatin1String("children")).toArray()) {
        addNodeTypes(child.toObject(), types);
    }
}

}  // namespace

bool isUrpFile(const QByteArray& content) {
    return isGzip(content) || content.left(4096).contains("<URProgram") ||
           content.left(4096).contains("ProgramRootNode");
}

Result<PendantProgram> readUrp(const QByteArray& content, const QString& name, const PendantSource& source) {
    const Result<std::unique_ptr<XmlElement>> root = readPendantFile(content);
    if (!root) {
        return root.error();
    }
    if (source.keepsDisabled) {
        nameDisabledNodes(**root);
    }
    const Result<Installation> installation = installationOf(**root, source);
    if (!installation) {
        return Error{ErrorCode::FileCorrupt,
                     QStringLiteral("the installation cannot be read: %1").arg(installation.error().context),
                     {}};
    }
    return ProgramTranslator(source, *installation).translate(**root, name);
}

Result<PendantProgram> readUrpx(const QByteArray& content) {
    QJsonParseError damage{};
    const QJsonObject root = QJsonDocument::fromJson(content, &damage).object();
    if (damage.error != QJsonParseError::NoError) {
        return Error{
            ErrorCode::FileCorrupt, QStringLiteral("this is not JSON: %1").arg(damage.errorString()), {}};
    }
    const auto part = [&root](const char* which) {
        return root.value(QLatin1String(which))
            .toObject()
            .value(QLatin1String("urscript"))
            .toObject()
            .value(QLatin1String("script"));
    };
    // Combine the parts of the application (frames, functions, threads) and of the program.
    if (const QJsonValue program = part("program"); program.isString()) {
        return PendantProgram{"def program():\n" + part("application").toString().toStdString() + '\n' +
                              program.toString().toStdString() + "\nend\n"};
    }
    if (const QJsonValue script = root.value(QLatin1String("script")); script.isString()) {
        return PendantProgram{script.toString().toStdString()};
    }
    QStringList types;
    addNodeTypes(
        root.value(QLatin1String("program")).toObject().value(QLatin1String("programContent")).toObject(),
        types);
    QString reason =
        QStringLiteral("the program contains no URScript, and there is no .script file in the same folder");
    if (!types.isEmpty()) {
        reason += QStringLiteral("; the simulated controller cannot run these nodes of the program: %1")
                      .arg(types.join(QStringLiteral(", ")));
    }
    return Error{ErrorCode::FileCorrupt, reason, {}};
}

}  // namespace tiller::simulator::pendant
