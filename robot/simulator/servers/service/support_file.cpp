// SPDX-License-Identifier: MIT
#include "robot/simulator/servers/service/support_file.h"

#include <zlib.h>
#include <QtEndian>

namespace tiller::simulator {

namespace {

template <class Number>
void put(QByteArray& into, Number value) {
    char bytes[sizeof(Number)];
    qToLittleEndian(value, bytes);
    into.append(bytes, sizeof bytes);
}

}  // namespace

QByteArray zipOf(const QByteArray& fileName, const QByteArray& content) {
    constexpr quint16 kVersion = 20, kStored = 0, kFirstDay = (1 << 5) | 1;  // 1980-01-01
    const auto sum = static_cast<quint32>(
        crc32(0, reinterpret_cast<const Bytef*>(content.constData()), static_cast<uInt>(content.size())));
    const auto size = static_cast<quint32>(content.size());
    // The header is written twice: before the content and in the directory at the end.
    QByteArray entry;
    put(entry, kVersion);
    put(entry, quint16(0));
    put(entry, kStored);
    put(entry, quint16(0));
    put(entry, kFirstDay);
    put(entry, sum);
    put(entry, size);
    put(entry, size);
    put(entry, static_cast<quint16>(fileName.size()));
    put(entry, quint16(0));

    QByteArray zip("PK\x03\x04", 4);
    zip += entry + fileName + content;
    const auto directory = static_cast<quint32>(zip.size());
    zip += QByteArray("PK\x01\x02", 4);
    put(zip, kVersion);
    zip += entry;
    zip += QByteArray(14, '\0');  // no comment, first disk, no attributes, at offset 0
    zip += fileName;
    const auto directorySize = static_cast<quint32>(zip.size()) - directory;
    zip += QByteArray("PK\x05\x06\0\0\0\0\1\0\1\0", 12);
    put(zip, directorySize);
    put(zip, directory);
    put(zip, quint16(0));
    return zip;
}

}  // namespace tiller::simulator
