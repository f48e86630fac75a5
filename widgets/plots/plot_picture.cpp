// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/plot_picture.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QEvent>
#include <QFileInfo>
#include <QImage>
#include <QPainter>
#include <QPdfWriter>
#include <QSvgGenerator>

#include "robot/core/atomic_file.h"
#include "widgets/common/theme.h"
#include "widgets/plots/plot_view.h"

namespace tiller {

namespace {

constexpr QSize kPlots(1200, 560);  // [px]
constexpr int kTitleHeight = 56;
constexpr int kMargin = 16;
constexpr double kFineness = 2;  // pixels of the .png file per pixel of the page
constexpr double kPointsPerPixel = 0.75;
constexpr QSize kPage(kPlots.width() + 2 * kMargin, kPlots.height() + kTitleHeight + kMargin);

/// The content of the page, laid out in pixels.
class Page {
public:
    Page(const PlotView& view, SignalStore& store, const StateLane& lane, PictureText text)
        : plots_(store, lane, view.marks()), text_(std::move(text)) {
        // The widget must be laid out, but must not appear on a screen.
        plots_.setAttribute(Qt::WA_DontShowOnScreen);
        plots_.resize(kPlots);
        plots_.setVisible(true);
        plots_.showLike(view, true);
        plots_.showSharp();
        // QChart places its labels in a layout request, so deliver it without the event loop.
        QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
    }

    void paint(QPainter& painter) {
        const Theme& theme = Theme::current();
        painter.setRenderHint(QPainter::Antialiasing);
        painter.fillRect(QRect(QPoint(0, 0), kPage), Qt::white);
        painter.setPen(theme.text);
        painter.setFont(textFont(18, QFont::DemiBold));
        painter.drawText(QRect(kMargin, 8, kPlots.width(), 26), Qt::AlignLeft | Qt::AlignVCenter,
                         text_.title);
        painter.setPen(theme.secondary);
        painter.setFont(textFont(13));
        painter.drawText(QRect(kMargin, 32, kPlots.width(), 20), Qt::AlignLeft | Qt::AlignVCenter,
                         text_.detail);
        // The view also draws notes, limits and the offset of the force. The scene does not contain them.
        plots_.render(&painter, QRectF(QPointF(kMargin, kTitleHeight), kPlots), QRect(QPoint(0, 0), kPlots));
    }

private:
    const PaperColors paper_;  // first member, because the plots read the colours during their construction
    PlotView plots_;
    PictureText text_;
};

QByteArray png(Page& page) {
    QImage image(kPage * kFineness, QImage::Format_RGB32);
    image.setDevicePixelRatio(kFineness);
    {
        QPainter painter(&image);
        page.paint(painter);
    }
    QByteArray bytes;
    QBuffer buffer(&bytes);
    image.save(&buffer, "PNG");
    return bytes;
}

QByteArray svg(Page& page, const QString& title) {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    QSvgGenerator generator;
    generator.setOutputDevice(&buffer);
    generator.setSize(kPage);
    generator.setViewBox(QRect(QPoint(0, 0), kPage));
    generator.setTitle(title);
    QPainter painter(&generator);
    page.paint(painter);
    painter.end();
    return bytes;
}

QByteArray pdf(Page& page, const QString& title) {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    QPdfWriter writer(&buffer);
    writer.setTitle(title);
    writer.setCreator(QStringLiteral("Tiller"));
    writer.setPageSize(QPageSize(QSizeF(kPage) * kPointsPerPixel, QPageSize::Point));
    writer.setPageMargins({});
    constexpr int kDotsPerInch = 96;
    writer.setResolution(kDotsPerInch);
    QPainter painter(&writer);
    page.paint(painter);
    painter.end();
    return bytes;
}

}  // namespace

Result<void> exportPicture(const PlotView& view, SignalStore& store, const StateLane& lane,
                           const PictureText& text, const QString& path) {
    const QString ending = QFileInfo(path).suffix().toLower();
    if (ending != QLatin1String("png") && ending != QLatin1String("svg") && ending != QLatin1String("pdf")) {
        return Error{ErrorCode::InvalidArgument,
                     QCoreApplication::translate("tiller::PlotDock",
                                                 "The file type is not supported. Use the suffix .png, .svg "
                                                 "or .pdf for an image, or .csv for values."),
                     {}};
    }
    Page page(view, store, lane, text);
    const QByteArray bytes = ending == QLatin1String("png")   ? png(page)
                             : ending == QLatin1String("svg") ? svg(page, text.title)
                                                              : pdf(page, text.title);
    return bytes.isEmpty() ? Error{ErrorCode::Internal,
                                   QCoreApplication::translate(
                                       "tiller::PlotDock",
                                       "The image %1 could not be created. Choose a different image format.")
                                       .arg(path),
                                   {}}
                           : writeFileAtomically(path, bytes);
}

}  // namespace tiller
