// SPDX-License-Identifier: MIT
#include "robot/simulator/programs/program_store.h"

#include <QDir>
#include <QFileInfo>
#include <QStringList>
#include <algorithm>

#include "robot/core/atomic_file.h"
#include "robot/core/file_reading.h"

namespace tiller::simulator {

namespace {

/// Program folders of a robot and of the vendor's simulator. Clients use full paths.
constexpr const char* kProgramRoots[] = {"/ursim/programs/", "/programs/"};

std::optional<QByteArray> contentOf(const QString& path) {
    const Result<QByteArray> content = readWholeFile(path, kLargestProgram);
    return content ? std::optional(*content) : std::nullopt;
}

Error notThere(const QString& name) {
    return {ErrorCode::FileNotReadable,
            QStringLiteral("there is no file '%1' in the programs folder").arg(name),
            {}};
}

}  // namespace

/// True if the file exists and, after resolving links, is within the folder.
bool ProgramStore::isWithin(const QString& path) const {
    const QString root = QDir(folder_).canonicalPath();
    const QString real = QFileInfo(path).canonicalFilePath();
    return !root.isEmpty() && !real.isEmpty() &&
           (real == root || real.startsWith(root.endsWith('/') ? root : root + '/'));
}

std::optional<QString> ProgramStore::find(const QString& name) const {
    if (folder_.isEmpty() || name.isEmpty() || name.contains(QChar(0))) {
        return std::nullopt;
    }
    const QString folder = QDir(folder_).absolutePath() + '/';
    QStringList candidates;
    for (const char* const root : kProgramRoots) {
        if (name.startsWith(QLatin1String(root))) {
            candidates << folder + name.mid(QLatin1String(root).size());
        }
    }
    // Absolute paths are not changed. isWithin() checks them after resolving links.
    candidates << (QDir::isAbsolutePath(name) ? name : folder + name);
    const auto found = std::ranges::find_if(
        candidates, [this](const QString& path) { return QFileInfo(path).isFile() && isWithin(path); });
    return found == candidates.end() ? std::nullopt : std::optional(*found);
}

/// Reads a file whose name was given by a client or a program.
std::optional<QByteArray> ProgramStore::read(const QString& name) const {
    const std::optional<QString> path = find(name);
    return path ? contentOf(*path) : std::nullopt;
}

/// Reads a resolved path. Resolving it a second time could match a folder `/programs/` on this PC.
std::optional<QByteArray> ProgramStore::readPath(const QString& path) const {
    return isWithin(path) ? contentOf(path) : std::nullopt;
}

Result<pendant::PendantProgram> ProgramStore::programAt(const QString& path) const {
    const std::optional<QByteArray> content = readPath(path);
    if (!content) {
        return notThere(path);
    }
    const QFileInfo file(path);
    const bool urpx = file.suffix() == QLatin1String("urpx");
    const bool urp = pendant::isUrpFile(*content);
    if (!urp && !urpx) {
        return pendant::PendantProgram{content->toStdString()};
    }
    const QString scriptName = file.completeBaseName() + QStringLiteral(".script");
    if (const auto beside = readPath(file.dir().filePath(scriptName))) {
        return pendant::PendantProgram{beside->toStdString()};
    }
    if (!urp) {
        return pendant::readUrpx(*content);
    }
    pendant::PendantSource source = source_();
    source.installation = installation_;
    // Names are relative to the program or to the programs folder.
    source.files = [this, &file](const QString& name) {
        const std::optional<QByteArray> beside =
            QDir::isAbsolutePath(name) ? std::nullopt : readPath(file.dir().filePath(name));
        return beside ? beside : read(name);
    };
    return pendant::readUrp(*content, file.completeBaseName(), source);
}

Result<void> ProgramStore::load(const QString& name) {
    const std::optional<QString> path = find(name);
    if (!path) {
        return notThere(name);
    }
    if (const Result<pendant::PendantProgram> program = programAt(*path); !program) {
        return Error{ErrorCode::FileCorrupt, program.error().context, {}};
    }
    path_ = *path;
    name_ = QFileInfo(*path).fileName().toStdString();
    return {};
}

Result<void> ProgramStore::loadInstallation(const QString& name) {
    const std::optional<QString> path = find(name);
    if (!path) {
        return name == QLatin1String("default.installation") ? Result<void>() : notThere(name);
    }
    if (!contentOf(*path)) {
        return Error{ErrorCode::FileCorrupt, QStringLiteral("'%1' cannot be read").arg(name), {}};
    }
    installation_ = name;
    return {};
}

ScriptProvider ProgramStore::scriptProvider() const {
    const std::optional<QByteArray> content = read(installation_);
    return content ? scriptProviderOf(*content).value_or(ScriptProvider()) : ScriptProvider();
}

Result<std::string> ProgramStore::script() const {
    Result<pendant::PendantProgram> program =
        isLoaded() ? programAt(path_) : Result<pendant::PendantProgram>(notThere(QString()));
    if (!program) {
        return program.error();
    }
    if (program->unfinished) {
        return Error{ErrorCode::FileCorrupt,
                     QStringLiteral("the program is incomplete: %1").arg(program->unfinished->context),
                     {}};
    }
    std::string text = std::move(program->script);
    if (!text.ends_with('\n')) {
        text += '\n';
    }
    return text;
}

bool ProgramStore::saveBelow(const QString& directory, const QString& bareName,
                             const QByteArray& content) const {
    if (folder_.isEmpty() || directory.isEmpty()) {
        return false;
    }
    const QDir path(QDir(folder_).filePath(directory));
    if (!isWithin(path.path()) || !path.exists()) {
        return false;
    }
    const QFileInfo target(path.filePath(bareName));
    if (target.isSymLink()) {
        return false;
    }
    return writeFileAtomically(target.filePath(), content).ok();
}

std::vector<QString> ProgramStore::list(const QString& ending) const {
    std::vector<QString> names;
    if (!folder_.isEmpty()) {
        for (const QString& name :
             QDir(folder_).entryList({QStringLiteral("*") + ending}, QDir::Files, QDir::Name)) {
            if (!pathOf(name).isEmpty()) {
                names.push_back(name);
            }
        }
    }
    return names;
}

QString ProgramStore::pathOf(const QString& bareName) const {
    const bool bare = !bareName.isEmpty() && !bareName.contains('/') && !bareName.contains('\\') &&
                      !bareName.contains(QChar(0)) && !bareName.startsWith('.');
    if (!bare || folder_.isEmpty()) {
        return {};
    }
    const QFileInfo file(QDir(folder_).filePath(bareName));
    // Writing to a dangling link would create its target.
    const bool free = !file.exists() && !file.isSymLink();
    return free || isWithin(file.filePath()) ? file.filePath() : QString();
}

bool ProgramStore::save(const QString& bareName, const QByteArray& content) {
    if (folder_.isEmpty()) {
        own_ = std::make_unique<QTemporaryDir>();
        folder_ = own_->path();
    }
    const QString path = pathOf(bareName);
    return !path.isEmpty() && writeFileAtomically(path, content).ok();
}

}  // namespace tiller::simulator
