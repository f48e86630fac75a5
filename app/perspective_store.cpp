// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/perspective_store.h"

#include <QCryptographicHash>
#include <QSettings>
#include <algorithm>

#include "app/settings.h"

namespace tiller::app {
namespace {

constexpr int kSealLength = 16;

QByteArray sealOf(const QByteArray& panels) {
    return QCryptographicHash::hash(panels, QCryptographicHash::Sha256).first(kSealLength);
}

QByteArray sealed(const QByteArray& panels) {
    return sealOf(panels) + panels;
}

/// Empty when it is not as it was written.
QByteArray unsealed(const QByteArray& kept) {
    const QByteArray panels = kept.mid(kSealLength);
    return !panels.isEmpty() && kept.startsWith(sealOf(panels)) ? panels : QByteArray();
}

}  // namespace

QVector<SavedPerspective> readPerspectives(const QString& file) {
    QVector<SavedPerspective> perspectives;
    QSettings settings = openSettings(file);
    const int count = std::min(settings.beginReadArray("perspectives"), kMostPerspectives);
    for (int i = 0; i < count; ++i) {
        settings.setArrayIndex(i);
        const SavedPerspective read{settings.value("number").toInt(),
                                    settings.value("name").toString().trimmed().left(kLongestPerspectiveName),
                                    settings.value("tab").toString(),
                                    unsealed(settings.value("panels").toByteArray())};
        const bool twice = std::any_of(perspectives.begin(), perspectives.end(), [&read](const auto& other) {
            return other.number == read.number || other.name.compare(read.name, Qt::CaseInsensitive) == 0;
        });
        if (read.number > 0 && !read.name.isEmpty() && !twice) {
            perspectives.append(read);
        }
    }
    return perspectives;
}

void writePerspectives(const QString& file, const QVector<SavedPerspective>& perspectives) {
    QSettings settings = openSettings(file);
    settings.remove("perspectives");
    settings.beginWriteArray("perspectives", static_cast<int>(perspectives.size()));
    for (int i = 0; i < perspectives.size(); ++i) {
        settings.setArrayIndex(i);
        settings.setValue("number", perspectives[i].number);
        settings.setValue("name", perspectives[i].name);
        settings.setValue("tab", perspectives[i].tab);
        settings.setValue("panels",
                          perspectives[i].panels.isEmpty() ? QByteArray() : sealed(perspectives[i].panels));
    }
    settings.endArray();
}

LastArrangement readArrangement(const QString& file) {
    using Found = LastArrangement::Found;
    QSettings settings = openSettings(file);
    LastArrangement last;
    if (!settings.contains("arrangement/panels")) {
        // As earlier versions wrote it, whose panels were others.
        last.found = settings.contains("window/state") ? Found::Older : Found::Nothing;
        return last;
    }
    last.perspective = settings.value("arrangement/perspective").toString();
    last.changed = settings.value("arrangement/changed").toBool();
    last.panels = unsealed(settings.value("arrangement/panels").toByteArray());
    last.jogWidth = std::clamp(settings.value("arrangement/jogWidth").toInt(), 0, 4000);
    last.found = last.panels.isEmpty() ? Found::Damaged : Found::Usable;
    return last;
}

void writeArrangement(const QString& file, const LastArrangement& arrangement) {
    QSettings settings = openSettings(file);
    settings.setValue("arrangement/perspective", arrangement.perspective);
    settings.setValue("arrangement/changed", arrangement.changed);
    settings.setValue("arrangement/panels", sealed(arrangement.panels));
    settings.setValue("arrangement/jogWidth", arrangement.jogWidth);
    settings.remove("window/state");
    settings.remove("window/version");
}

}  // namespace tiller::app
