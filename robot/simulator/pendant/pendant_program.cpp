// SPDX-License-Identifier: MIT
#include "robot/simulator/programs/urp_file.h"

#include <zlib.h>
#include <utility>

#include "robot/simulator/programs/urp_writer.h"

namespace tiller::simulator {

namespace {

constexpr qsizetype kLargestXml = 64 << 20;

bool isGzip(const QByteArray& content) {
    return content.startsWith("\x1f\x8b");
}

}  // namespace

std::optional<QByteArray> gunzip(const QByteArray& compressed, qsizetype most) {
    if (!isGzip(compressed)) {
        return std::nullopt;
    }
    z_stream stream{};
    constexpr int kGzipOnly = 16 + MAX_WBITS;
    if (inflateInit2(&stream, kGzipOnly) != Z_OK) {
        return std::nullopt;
    }
    // zlib reads only; its interface is older than const.
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(compressed.constData()));
    stream.avail_in = static_cast<uInt>(compressed.size());
    QByteArray out;
    QByteArray piece(64 * 1024, Qt::Uninitialized);
    int state = Z_OK;
    while (state == Z_OK && out.size() <= most) {
        stream.next_out = reinterpret_cast<Bytef*>(piece.data());
        stream.avail_out = static_cast<uInt>(piece.size());
        state = inflate(&stream, Z_NO_FLUSH);
        out.append(piece.constData(), piece.size() - static_cast<qsizetype>(stream.avail_out));
    }
    inflateEnd(&stream);
    return state == Z_STREAM_END && out.size() <= most ? std::optional(out) : std::nullopt;
}

bool isUrpFile(const QByteArray& content) {
    return isGzip(content) || content.left(4096).contains("<URProgram");
}

namespace {

Result<std::unique_ptr<UrpElement>> treeOf(const QByteArray& content) {
    const std::optional<QByteArray> xml = isGzip(content) ? gunzip(content, kLargestXml) : content;
    if (!xml) {
        return Error{
            ErrorCode::FileCorrupt, QStringLiteral("the compressed data are damaged or too much"), {}};
    }
    return readUrpTree(*xml);
}

}  // namespace

Result<std::string> scriptOfUrp(const QByteArray& content, const QString& name, const FileReader& files) {
    const Result<std::unique_ptr<UrpElement>> root = treeOf(content);
    if (!root) {
        return root.error();
    }
    const UrpTreeReader trees = [&files](const QString& file) -> Result<std::unique_ptr<UrpElement>> {
        const std::optional<QByteArray> other = files(file);
        if (!other) {
            return Error{ErrorCode::FileNotReadable,
                         QStringLiteral("there is no file '%1' in the programs folder").arg(file),
                         {}};
        }
        return treeOf(*other);
    };
    return UrpWriter(trees, files).write(**root, name);
}

}  // namespace tiller::simulator
