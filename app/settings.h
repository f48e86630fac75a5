// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What the program remembers between two starts. Never a speed: every start begins slowly.

#include <QByteArray>
#include <QMap>
#include <QString>
#include <QStringList>
#include <QVector>

#include "widgets/session/robot_session.h"

namespace tiller::app {

class Settings {
public:
    /// file  where they are kept; empty: the place the system has for them
    explicit Settings(QString file = {});

    /// Newest first. The simulated robot is none of them.
    QVector<RobotAddress> rememberedRobots() const;
    void rememberRobot(const RobotAddress& robot);
    void forgetRobot(const QString& host);
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
    void writeRobots(const QVector<RobotAddress>& robots);

    QString file_;
};

}  // namespace tiller::app
