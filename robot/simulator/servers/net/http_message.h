// SPDX-License-Identifier: MIT
#pragma once

// HTTP/1.1 on byte level: parses requests from a stream, writes responses to one, and parses multipart forms
// with files.
//
// Not Qt's QHttpServer, because its license is GPL-3.0-only and robot/ is MIT, to be linked by others; it
// also owns its sockets, so that link faults could not be simulated on them.

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tiller::simulator {

struct HttpRequest {
    std::string method;                                        ///< "GET"
    std::string path;                                          ///< decoded, without the query
    std::vector<std::pair<std::string, std::string>> headers;  ///< names in lower case
    std::string body;
    bool keepAlive = true;

    /// Empty when there is no such header. name  in lower case
    std::string_view header(std::string_view name) const;
};

struct HttpResponse {
    int status = 200;
    std::string body;
    std::string contentType = "application/json";
    std::vector<std::pair<std::string, std::string>> headers;
    std::function<bool()> due;  ///< the answer is delayed until this returns true; empty: immediate

    std::string toBytes(bool keepAlive, bool withBody) const;
};

/// Memory is bounded for any input.
class HttpParser {
public:
    static constexpr std::size_t kLargestHead = 32 * 1024;
    static constexpr std::size_t kLargestBody = 16 * 1024 * 1024;

    void feed(std::string_view bytes);
    /// The next complete request; nothing if none is complete, or after an error.
    std::optional<HttpRequest> next();
    /// Status to answer with before closing the connection; 0 without an error: 400, 413, 431, 501, 505.
    int fault() const { return fault_; }
    /// True once after a head that expects "100 Continue" before the body.
    bool takeContinue() { return std::exchange(continue_, false); }

private:
    bool readHead();
    void readHeader(std::string_view line);
    bool readBody();
    bool readChunks();
    std::optional<std::string_view> line();
    void fail(int status) { fault_ = fault_ == 0 ? status : fault_; }

    std::string buffer_;
    std::size_t at_ = 0;  ///< number of processed bytes of the buffer
    HttpRequest request_;
    std::size_t headSize_ = 0;
    bool inBody_ = false;
    bool chunked_ = false;
    bool sawLength_ = false;
    std::size_t length_ = 0;
    std::optional<std::size_t> chunk_;  ///< remaining bytes of the current chunk
    bool inTrailer_ = false;
    bool continue_ = false;
    int fault_ = 0;
};

/// Decodes %41 and similar; nothing if a % is not followed by a hexadecimal number.
std::optional<std::string> percentDecoded(std::string_view text);

struct FormFile {
    std::string fileName;
    std::string content;
};
/// The field of that name from a multipart/form-data body.
std::optional<FormFile> fileOfForm(std::string_view contentType, std::string_view body,
                                   std::string_view field);

}  // namespace tiller::simulator
