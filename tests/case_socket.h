// SPDX-License-Identifier: GPL-2.0-or-later
// What case_client tells case_server: where and with what to start, and its own
// standard streams.
#ifndef mixed_cracks_tests_case_socket_h
#define mixed_cracks_tests_case_socket_h

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

namespace CaseSocket
{
  struct Request
  {
    std::string              directory;
    std::vector<std::string> arguments;
    std::vector<std::string> environment; ///< "NAME=value" each
    int                      streams[3] = {0, 1, 2};
  };

  inline sockaddr_un
  address_of(const std::string &path)
  {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    if (path.size() >= sizeof(address.sun_path))
      throw std::runtime_error("too long a name of a socket: " + path);
    std::memcpy(address.sun_path, path.c_str(), path.size() + 1);
    return address;
  }

  inline void
  require(const bool good)
  {
    if (!good)
      throw std::runtime_error("a request is incomplete");
  }

  // The length of a text and room for three streams, as the system wants them.
  struct Header
  {
    std::uint64_t length = 0;
    iovec         part{&length, sizeof(length)};
    alignas(cmsghdr) char space[CMSG_SPACE(sizeof(Request::streams))] = {};
    msghdr message{};

    Header()
    {
      message.msg_iov        = &part;
      message.msg_iovlen     = 1;
      message.msg_control    = space;
      message.msg_controllen = sizeof(space);
    }

    Header(const Header &)            = delete;
    Header &operator=(const Header &) = delete;
  };

  // Words ended by zeros: the directory, the number of arguments, these, the
  // environment; the first bytes are their length, which the streams go with.
  inline void
  send(const int connection, const Request &request)
  {
    std::string text = request.directory + '\0' +
                       std::to_string(request.arguments.size()) + '\0';
    for (const auto *words : {&request.arguments, &request.environment})
      for (const std::string &word : *words)
        text += word + '\0';
    Header first;
    first.length          = text.size();
    cmsghdr *const header = CMSG_FIRSTHDR(&first.message);
    header->cmsg_level    = SOL_SOCKET;
    header->cmsg_type     = SCM_RIGHTS;
    header->cmsg_len      = CMSG_LEN(sizeof(request.streams));
    std::memcpy(CMSG_DATA(header), request.streams, sizeof(request.streams));
    require(sendmsg(connection, &first.message, 0) == sizeof(first.length));
    for (std::size_t sent = 0; sent < text.size();)
    {
      const ssize_t n =
        write(connection, text.data() + sent, text.size() - sent);
      require(n > 0);
      sent += n;
    }
  }

  inline Request
  receive(const int connection)
  {
    Request request;
    Header  first;
    require(recvmsg(connection, &first.message, MSG_WAITALL) ==
            sizeof(first.length));
    require(CMSG_FIRSTHDR(&first.message) != nullptr);
    std::memcpy(request.streams,
                CMSG_DATA(CMSG_FIRSTHDR(&first.message)),
                sizeof(request.streams));
    std::string text(first.length, '\0');
    for (std::size_t got = 0; got < text.size();)
    {
      const ssize_t n = read(connection, &text[got], text.size() - got);
      require(n > 0);
      got += n;
    }
    std::vector<std::string> words;
    for (std::size_t begin = 0; begin < text.size();)
    {
      words.emplace_back(text.c_str() + begin);
      begin += words.back().size() + 1;
    }
    require(words.size() >= 2);
    request.directory = words[0];
    const auto last   = words.begin() + 2 + std::stoul(words[1]);
    request.arguments.assign(words.begin() + 2, last);
    request.environment.assign(last, words.end());
    return request;
  }
} // namespace CaseSocket

#endif
