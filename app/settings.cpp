// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/settings.h"

#include <QSettings>

namespace tiller::app {
namespace {

constexpr int kHostsRemembered = 8;
/// Raised when the docks change so much that an old layout would not fit.
constexpr int kLayoutVersion = 1;

QSettings open(const QString& file) {
    return file.isEmpty() ? QSettings(QStringLiteral("Tiller"), QStringLiteral("Tiller"))
                          : QSettings(file, QSettings::IniFormat);
}

}  // namespace

Settings::Settings(QString file) : file_(std::move(file)) {}

QStringList Settings::rememberedHosts() const {
    return open(file_).value("robots/hosts").toStringList();
}

void Settings::rememberHost(const QString& host) {
    QStringList hosts = rememberedHosts();
    hosts.removeAll(host);
    hosts.prepend(host);
    open(file_).setValue("robots/hosts", QStringList(hosts.mid(0, kHostsRemembered)));
}

QString Settings::theme() const {
    const QString theme = open(file_).value("look/theme").toString();
    return theme == "light" || theme == "dark" ? theme : QString();
}

void Settings::setTheme(const QString& theme) {
    open(file_).setValue("look/theme", theme);
}

QByteArray Settings::windowGeometry() const {
    return open(file_).value("window/geometry").toByteArray();
}

QByteArray Settings::windowState() const {
    const QSettings settings = open(file_);
    return settings.value("window/version").toInt() == kLayoutVersion
               ? settings.value("window/state").toByteArray()
               : QByteArray();
}

void Settings::setWindow(const QByteArray& geometry, const QByteArray& state) {
    QSettings settings = open(file_);
    settings.setValue("window/geometry", geometry);
    settings.setValue("window/state", state);
    settings.setValue("window/version", kLayoutVersion);
}

QMap<QString, QString> Settings::ioNames() const {
    QMap<QString, QString> names;
    QSettings settings = open(file_);
    settings.beginGroup("io");
    const QStringList terminals = settings.childKeys();
    for (const QString& terminal : terminals) {
        names[terminal] = settings.value(terminal).toString();
    }
    return names;
}

void Settings::setIoNames(const QMap<QString, QString>& names) {
    QSettings settings = open(file_);
    settings.remove("io");
    settings.beginGroup("io");
    for (auto it = names.constBegin(); it != names.constEnd(); ++it) {
        settings.setValue(it.key(), it.value());
    }
}

QString Settings::sessionFile() const {
    return open(file_).value("session/file").toString();
}

void Settings::setSessionFile(const QString& path) {
    open(file_).setValue("session/file", path);
}

}  // namespace tiller::app
