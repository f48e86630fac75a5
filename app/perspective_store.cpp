// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/perspective_store.h"

#include <QCryptographicHash>
#include <algorithm>

#include "app/settings_store.h"

namespace tiller::app {
namespace {

constexpr int kSealLength = 16;

QByteArray sealOf(const QByteArray& panels) {
    return QCryptographicHash::hash(panels, QCryptographicHash::Sha256).first(kSealLength);
}

QByteArray sealed(const QByteArray& panels) {
    return sealOf(panels) + panels;
}

/// Returns the layout without its checksum; empty if the checksum is not correct.
QByteArray unsealed(const QByteArray& kept) {
    const QByteArray panels = kept.mid(kSealLength);
    return !panels.isEmpty() && kept.startsWith(sealOf(panels)) ? panels : QByteArray();
}

}  // namespace

QVector<SavedPerspective> readPerspectives(const SettingsView& settings) {
    QVector<SavedPerspective> perspectives;
    const int count = std::min(settings.value(QStringLiteral("perspectives/size")).toInt(), kMaxPerspectives);
    for (int i = 0; i < count; ++i) {
        const auto field = [&settings, i](const char* name) {
            return settings.value(QStringLiteral("perspectives/%1/%2").arg(i + 1).arg(QLatin1String(name)));
        };
        const SavedPerspective read{field("number").toInt(),
                                    field("name").toString().trimmed().left(kMaxPerspectiveName),
                                    field("tab").toString(), unsealed(field("panels").toByteArray())};
        const bool twice = std::any_of(perspectives.begin(), perspectives.end(), [&read](const auto& other) {
            return other.number == read.number || other.name.compare(read.name, Qt::CaseInsensitive) == 0;
        });
        if (read.number > 0 && !read.name.isEmpty() && !twice) {
            perspectives.append(read);
        }
    }
    return perspectives;
}

void writePerspectives(SettingsEdit& settings, const QVector<SavedPerspective>& perspectives) {
    settings.remove(QStringLiteral("perspectives"));
    settings.setValue(QStringLiteral("perspectives/size"), static_cast<int>(perspectives.size()));
    for (int i = 0; i < perspectives.size(); ++i) {
        const auto set = [&settings, i](const char* name, const QVariant& value) {
            settings.setValue(QStringLiteral("perspectives/%1/%2").arg(i + 1).arg(QLatin1String(name)),
                              value);
        };
        set("number", perspectives[i].number);
        set("name", perspectives[i].name);
        set("tab", perspectives[i].tab);
        set("panels", perspectives[i].panels.isEmpty() ? QByteArray() : sealed(perspectives[i].panels));
    }
}

QVector<SavedPerspective> mergePerspectives(const QVector<SavedPerspective>& before,
                                            const QVector<SavedPerspective>& ours,
                                            QVector<SavedPerspective> there) {
    const auto withNumber = [](auto& list, int number) {
        return std::find_if(list.begin(), list.end(),
                            [number](const auto& one) { return one.number == number; });
    };
    for (const SavedPerspective& old : before) {
        if (withNumber(ours, old.number) == ours.end()) {
            there.removeIf([&old](const SavedPerspective& one) { return one.number == old.number; });
        }
    }
    for (SavedPerspective mine : ours) {
        const auto old = withNumber(before, mine.number);
        const auto found = withNumber(there, mine.number);
        if (old != before.end()) {
            if (*old == mine) {
                continue;
            }
            if (found != there.end()) {
                *found = mine;
            } else {
                there.append(mine);  // deleted in another window, but changed in this window
            }
            continue;
        }
        // The perspective was added in this window. Another window may have added a perspective with the same
        // number or name.
        while (withNumber(there, mine.number) != there.end()) {
            ++mine.number;
        }
        const QString name = mine.name;
        const auto isTaken = [&there](const QString& wanted) {
            return std::any_of(there.begin(), there.end(), [&wanted](const auto& one) {
                return one.name.compare(wanted, Qt::CaseInsensitive) == 0;
            });
        };
        for (int copy = 2; isTaken(mine.name); ++copy) {
            mine.name = QStringLiteral("%1 %2").arg(name.left(kMaxPerspectiveName - 4)).arg(copy);
        }
        there.append(mine);
    }
    return there;
}

LastArrangement readArrangement(const SettingsView& settings) {
    using Found = LastArrangement::Found;
    LastArrangement last;
    if (!settings.contains("arrangement/panels")) {
        // Earlier versions had different panels and used this key.
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

void writeArrangement(SettingsEdit& settings, const LastArrangement& arrangement) {
    settings.setValue("arrangement/perspective", arrangement.perspective);
    settings.setValue("arrangement/changed", arrangement.changed);
    settings.setValue("arrangement/panels", sealed(arrangement.panels));
    settings.setValue("arrangement/jogWidth", arrangement.jogWidth);
    settings.remove("window/state");
    settings.remove("window/version");
}

}  // namespace tiller::app
