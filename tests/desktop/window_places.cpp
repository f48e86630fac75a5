// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tells the tests where things are on the screen. A plugin of Qt that the tests, and they alone, let the
// built program load (QT_QPA_GENERIC_PLUGINS): the program itself stays the one that ships. It looks and
// answers, and changes nothing.
//
// One line of a local socket asks, one line of JSON answers:
//   widget NAME    the first one of this objectName, those that are seen before those that are not
//   windows        what is open, the active one marked

#include <QApplication>
#include <QComboBox>
#include <QGenericPlugin>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLocalServer>
#include <QLocalSocket>
#include <QWidget>

namespace tiller::test {
namespace {

QJsonObject describe(const QWidget& widget) {
    const QRect place(widget.mapToGlobal(QPoint(0, 0)), widget.size());
    return {{"name", widget.objectName()},
            {"type", QString::fromLatin1(widget.metaObject()->className())},
            {"visible", widget.isVisible()},
            {"enabled", widget.isEnabled()},
            {"active", widget.isActiveWindow()},
            {"focus", widget.hasFocus()},
            {"text",
             widget.property(qobject_cast<const QComboBox*>(&widget) ? "currentText" : "text").toString()},
            {"toolTip", widget.toolTip()},
            {"x", place.x()},
            {"y", place.y()},
            {"width", place.width()},
            {"height", place.height()},
            {"window", qint64(widget.window()->internalWinId())}};
}

QByteArray lookFor(const QString& name) {
    const QWidget* found = nullptr;
    const QWidgetList all = QApplication::allWidgets();
    for (const QWidget* widget : all) {
        if (widget->objectName() == name &&
            (found == nullptr || (!found->isVisible() && widget->isVisible()))) {
            found = widget;
        }
    }
    return QJsonDocument(found == nullptr ? QJsonObject() : describe(*found)).toJson(QJsonDocument::Compact);
}

QByteArray openWindows() {
    QJsonArray windows;
    const QWidgetList all = QApplication::topLevelWidgets();
    for (const QWidget* widget : all) {
        if (widget->isVisible()) {
            windows.append(describe(*widget));
        }
    }
    return QJsonDocument(windows).toJson(QJsonDocument::Compact);
}

class WindowPlaces : public QObject {
public:
    explicit WindowPlaces(const QString& socket) {
        server_.listen(socket);
        connect(&server_, &QLocalServer::newConnection, this, [this] {
            QLocalSocket* peer = server_.nextPendingConnection();
            connect(peer, &QLocalSocket::disconnected, peer, &QObject::deleteLater);
            connect(peer, &QLocalSocket::readyRead, this, [peer] {
                while (peer->canReadLine()) {
                    const QStringList words =
                        QString::fromUtf8(peer->readLine()).trimmed().split(QLatin1Char(' '));
                    peer->write((words.first() == "widget" ? lookFor(words.last()) : openWindows()) + '\n');
                }
            });
        });
    }

private:
    QLocalServer server_;
};

}  // namespace

class WindowPlacesPlugin : public QGenericPlugin {
    Q_OBJECT
    Q_PLUGIN_METADATA(IID QGenericPluginFactoryInterface_iid FILE "window_places.json")

public:
    /// specification  the socket to answer on
    QObject* create(const QString& key, const QString& specification) override {
        return key.compare(QLatin1String("window_places"), Qt::CaseInsensitive) == 0
                   ? new WindowPlaces(specification)
                   : nullptr;
    }
};

}  // namespace tiller::test

#include "window_places.moc"
