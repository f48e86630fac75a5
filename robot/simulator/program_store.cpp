// SPDX-License-Identifier: MIT
#include "robot/simulator/program_store.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>

#include "robot/simulator/urp_file.h"

namespace tiller::simulator {

namespace {

constexpr qint64 kLargestProgram = 16 << 20;
/// Where a robot and the vendor's simulator keep their programs: clients name them in full.
constexpr const char* kProgramRoots[] = {"/ursim/programs/", "/programs/"};

std::optional<QByteArray> contentOf(const QString& path) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly) || file.size() > kLargestProgram) {
        return std::nullopt;
    }
    return file.readAll();
}

/// The application's part (frames, functions, threads) and the program's make one program.
std::optional<std::string> scriptOfUrpx(const QJsonObject& root) {
    const auto part = [&root](const char* which) {
        return root.value(QLatin1String(which))
            .toObject()
            .value(QLatin1String("urscript"))
            .toObject()
            .value(QLatin1String("script"));
    };
    const QJsonValue program = part("program");
    if (program.isString()) {
        return "def program():\n" + part("application").toString().toStdString() + '\n' +
               program.toString().toStdString() + "\nend\n";
    }
    const QJsonValue script = root.value(QLatin1String("script"));
    return script.isString() ? std::optional(script.toString().toStdString()) : std::nullopt;
}

std::optional<std::string> scriptOf(const QString& path) {
    const std::optional<QByteArray> content = contentOf(path);
    if (!content) {
        return std::nullopt;
    }
    const QFileInfo file(path);
    const bool urpx = file.suffix() == QLatin1String("urpx");
    const bool urp = isUrpFile(*content);
    if (!urp && !urpx) {
        return content->toStdString();
    }
    if (const auto beside =
            contentOf(file.dir().filePath(file.completeBaseName() + QStringLiteral(".script")))) {
        return beside->toStdString();
    }
    if (urp) {
        return scriptOfUrp(*content, file.completeBaseName());
    }
    return scriptOfUrpx(QJsonDocument::fromJson(*content).object());
}

}  // namespace

std::optional<QString> ProgramStore::find(const QString& name) const {
    if (folder_.isEmpty() || name.isEmpty() || name.contains(QChar(0))) {
        return std::nullopt;
    }
    QString path = QDir::isAbsolutePath(name) ? name : QDir(folder_).filePath(name);
    for (const char* const root : kProgramRoots) {
        if (!QFileInfo(path).isFile() && name.startsWith(QLatin1String(root))) {
            path = QDir(folder_).filePath(name.mid(QLatin1String(root).size()));
        }
    }
    return QFileInfo(path).isFile() ? std::optional(path) : std::nullopt;
}

ProgramStore::Outcome ProgramStore::load(const QString& name) {
    const std::optional<QString> path = find(name);
    if (!path) {
        return Outcome::NotFound;
    }
    if (!scriptOf(*path)) {
        return Outcome::Unreadable;
    }
    path_ = *path;
    name_ = QFileInfo(*path).fileName().toStdString();
    return Outcome::Done;
}

ProgramStore::Outcome ProgramStore::loadInstallation(const QString& name) {
    const std::optional<QString> path = find(name);
    if (!path) {
        return name == QLatin1String("default.installation") ? Outcome::Done : Outcome::NotFound;
    }
    if (!contentOf(*path)) {
        return Outcome::Unreadable;
    }
    installation_ = name;
    return Outcome::Done;
}

ScriptProvider ProgramStore::scriptProvider() const {
    const std::optional<QString> path = find(installation_);
    const std::optional<QByteArray> content = path ? contentOf(*path) : std::nullopt;
    return content ? scriptProviderOf(*content).value_or(ScriptProvider()) : ScriptProvider();
}

std::optional<std::string> ProgramStore::script() const {
    std::optional<std::string> text = isLoaded() ? scriptOf(path_) : std::nullopt;
    if (text && !text->ends_with('\n')) {
        *text += '\n';
    }
    return text;
}

bool ProgramStore::saveBelow(const QString& directory, const QString& bareName,
                             const QByteArray& content) const {
    if (folder_.isEmpty() || directory.isEmpty()) {
        return false;
    }
    const QString root = QDir(folder_).canonicalPath();
    const QString path = QFileInfo(QDir(folder_).filePath(directory)).canonicalFilePath();
    if (path.isEmpty() || !QFileInfo(path).isDir() || (path != root && !path.startsWith(root + '/'))) {
        return false;
    }
    QFile file(QDir(path).filePath(bareName));
    return file.open(QIODevice::WriteOnly) && file.write(content) == content.size();
}

std::vector<QString> ProgramStore::list(const QString& ending) const {
    std::vector<QString> names;
    if (!folder_.isEmpty()) {
        for (const QString& name :
             QDir(folder_).entryList({QStringLiteral("*") + ending}, QDir::Files, QDir::Name)) {
            names.push_back(name);
        }
    }
    return names;
}

QString ProgramStore::pathOf(const QString& bareName) const {
    const bool bare = !bareName.isEmpty() && !bareName.contains('/') && !bareName.contains('\\') &&
                      !bareName.contains(QChar(0)) && !bareName.startsWith('.');
    return bare && !folder_.isEmpty() ? QDir(folder_).filePath(bareName) : QString();
}

bool ProgramStore::save(const QString& bareName, const QByteArray& content) {
    if (folder_.isEmpty()) {
        own_ = std::make_unique<QTemporaryDir>();
        folder_ = own_->path();
    }
    const QString path = pathOf(bareName);
    QFile file(path);
    return !path.isEmpty() && file.open(QIODevice::WriteOnly) && file.write(content) == content.size();
}

}  // namespace tiller::simulator
