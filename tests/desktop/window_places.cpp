// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reports the positions of widgets on the screen to the tests. This is a Qt plugin that the built application
// loads only in tests (QT_QPA_GENERIC_PLUGINS), so that the tested application is the one that is shipped.
// The plugin only replies to queries and changes nothing.
//
// Each query is one line on a local socket, and each reply is one line of JSON:
//   widget NAME    the first widget with this objectName; visible widgets have priority
//   windows        all open windows; the active one is marked

#include <QAbstractButton>
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
            {"shaped", !widget.mask().isEmpty()},
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

QByteArray focusWidget() {
    const QWidget* focus = QApplication::focusWidget();
    return QJsonDocument(focus == nullptr ? QJsonObject() : describe(*focus)).toJson(QJsonDocument::Compact);
}

/// The selected buttons, e.g. the choices of the jog column.
QByteArray checkedButtons() {
    QJsonArray names;
    const QWidgetList all = QApplication::allWidgets();
    for (const QWidget* widget : all) {
        const auto* button = qobject_cast<const QAbstractButton*>(widget);
        if (button != nullptr && button->isVisible() && button->isChecked()) {
            names.append(button->objectName() + ' ' + button->text());
        }
    }
    return QJsonDocument(names).toJson(QJsonDocument::Compact);
}

QByteArray answerTo(const QStringList& words) {
    if (words.first() == "checked") {
        return checkedButtons();
    }
    if (words.first() == "widget") {
        return lookFor(words.last());
    }
    return words.first() == "focus" ? focusWidget() : openWindows();
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
                    peer->write(answerTo(words) + '\n');
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
    /// specification  name of the socket to listen on
    QObject* create(const QString& key, const QString& specification) override {
        return key.compare(QLatin1String("window_places"), Qt::CaseInsensitive) == 0
                   ? new WindowPlaces(specification)
                   : nullptr;
    }
};

}  // namespace tiller::test

#include "window_places.moc"
