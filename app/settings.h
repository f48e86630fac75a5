// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What the program remembers between two starts. Never a speed: every start begins slowly.

#include <QByteArray>
#include <QMap>
#include <QString>
#include <QStringList>

namespace tiller::app {

class Settings {
public:
    /// file  where they are kept; empty: the place the system has for them
    explicit Settings(QString file = {});

    QStringList rememberedHosts() const;
    void rememberHost(const QString& host);
    QString theme() const;  ///< "light" or "dark"; empty when never chosen
    void setTheme(const QString& theme);
    QByteArray windowState() const;
    QByteArray windowGeometry() const;
    void setWindow(const QByteArray& geometry, const QByteArray& state);
    /// The operator's names of inputs and outputs, by terminal: "DI 0".
    QMap<QString, QString> ioNames() const;
    void setIoNames(const QMap<QString, QString>& names);
    QString sessionFile() const;
    void setSessionFile(const QString& path);

private:
    QString file_;
};

}  // namespace tiller::app
