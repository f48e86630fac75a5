// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/icons.h"

#include <QFile>
#include <QPainter>
#include <QPixmap>
#include <QSvgRenderer>

#include "resources/resources.h"
#include "widgets/common/theme.h"

namespace tiller {

namespace {

void render(QIcon& icon, QIcon::Mode mode, const QByteArray& drawing, const QColor& ink) {
    QByteArray tinted = drawing;
    tinted.replace("#000000", ink.name().toLatin1());  // the only colour in the SVG files
    QSvgRenderer renderer(tinted);
    if (!renderer.isValid()) {
        return;
    }
    for (const int size : {16, 24, 32, 48}) {
        QPixmap pixmap(size, size);
        pixmap.fill(Qt::transparent);
        QPainter painter(&pixmap);
        renderer.render(&painter);
        painter.end();
        icon.addPixmap(pixmap, mode);
    }
}

QByteArray drawingOf(const QString& name) {
    initResources();
    QFile file(QStringLiteral(":/tiller/icons/%1.svg").arg(name));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

}  // namespace

QIcon themedIcon(const QString& name, const QColor& ink) {
    QIcon icon;
    const QByteArray drawing = drawingOf(name);
    if (!drawing.isEmpty()) {
        render(icon, QIcon::Normal, drawing, ink);
    }
    return icon;
}

QIcon themedIcon(const QString& name) {
    QIcon icon;
    const QByteArray drawing = drawingOf(name);
    if (!drawing.isEmpty()) {
        render(icon, QIcon::Normal, drawing, Theme::current().text);
        render(icon, QIcon::Disabled, drawing, Theme::current().disabledText);
    }
    return icon;
}

QIcon applicationIcon() {
    initResources();
    return QIcon(QStringLiteral(":/tiller/icons/tiller.svg"));
}

}  // namespace tiller
