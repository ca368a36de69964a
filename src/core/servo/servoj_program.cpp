// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/servo/servoj_program.hpp"

#include <cmath>

#include "lamina/base/number_text.hpp"
#include "lamina/base/placeholders.hpp"

namespace lamina {
namespace {

// Names of one letter are those of docs/nodes/servo_bridge.md: n the cycle of the newest target, phase the
// robot's own, u the share of the way ahead.
constexpr char kProgram[] = R"(def lamina_servo():
  global SCALE = 1000000.0
  global CYCLE = {cycle}
  global AHEAD = {ahead}
  global SILENT_CYCLES = {silent_cycles}
  global STOP = {stop}
  global REPORT = 1280507904
  global n = 0
  global is_over = False
  global q0 = get_actual_joint_positions()
  global v0 = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0]
  global q1 = q0
  global v1 = v0

  def along(a, va, b, vb, u):
    w = 1.0 - u
    return w * w * (1.0 + 2.0 * u) * a + u * u * (1.0 + 2.0 * w) * b + AHEAD * u * w * (w * va - u * vb)
  end

  def report(state, cycle):
    q = get_actual_joint_positions()
    socket_send_int(REPORT + state, "lamina")
    socket_send_int(cycle, "lamina")
    i = 0
    while i < 6:
      socket_send_int(floor(q[i] * SCALE + 0.5), "lamina")
      i = i + 1
    end
  end

  thread listen():
    while not is_over:
      frame = socket_read_binary_integer(25, "lamina", 0.5)
      if frame[0] == 25:
        enter_critical
        if frame[1] > 0:
          q0 = [frame[2] / SCALE, frame[3] / SCALE, frame[4] / SCALE, frame[5] / SCALE, frame[6] / SCALE, frame[7] / SCALE]
          v0 = [frame[8] / SCALE, frame[9] / SCALE, frame[10] / SCALE, frame[11] / SCALE, frame[12] / SCALE, frame[13] / SCALE]
          q1 = [frame[14] / SCALE, frame[15] / SCALE, frame[16] / SCALE, frame[17] / SCALE, frame[18] / SCALE, frame[19] / SCALE]
          v1 = [frame[20] / SCALE, frame[21] / SCALE, frame[22] / SCALE, frame[23] / SCALE, frame[24] / SCALE, frame[25] / SCALE]
          n = frame[1]
        else:
          is_over = True
        end
        exit_critical
      end
    end
  end

  if socket_open("{host}", {port}, "lamina"):
    listener = run listen()
    phase = 0.0
    last = 0
    silent = 0
    waited = 0.0
    while not is_over:
      enter_critical
      m = n
      a = q0
      va = v0
      b = q1
      vb = v1
      exit_critical
      if m == 0:
        waited = waited + CYCLE
        if waited > 5.0:
          is_over = True
        end
        report(0, 0)
        sync()
      else:
        if m == last:
          silent = silent + 1
        else:
          silent = 0
        end
        if silent > SILENT_CYCLES:
          is_over = True
          stopj(STOP)
          report(2, m)
        else:
          phase = phase + 1.0
          if last == 0:
            phase = m
          end
          if silent == 0:
            phase = phase + 0.005 * (m - phase)
          end
          if norm(m - phase) > 5.0 + silent:
            phase = m
          end
          last = m
          u = (phase - m) * CYCLE / AHEAD
          if u > 1.0:
            u = 1.0
          end
          servoj([along(a[0], va[0], b[0], vb[0], u), along(a[1], va[1], b[1], vb[1], u), along(a[2], va[2], b[2], vb[2], u), along(a[3], va[3], b[3], vb[3], u), along(a[4], va[4], b[4], vb[4], u), along(a[5], va[5], b[5], vb[5], u)], t=CYCLE, lookahead_time={lookahead}, gain={gain})
          report(1, m)
        end
      end
    end
    stopj(STOP)
    report(3, n)
    kill listener
    socket_close("lamina")
  else:
    textmsg("Lamina does not answer")
  end
end
)";

}  // namespace

std::string servojProgram(const ServojSettings& settings, const std::string& host, std::uint16_t port) {
  const double silent_cycles = std::round(settings.silence_s / settings.cycle());
  return expandPlaceholders("servoj", kProgram, [&](const std::string& name) {
    if (name == "cycle") return numberText(settings.cycle());
    if (name == "ahead") return numberText(settings.ahead());
    if (name == "silent_cycles") return numberText(silent_cycles);
    if (name == "stop") return numberText(settings.stop_rad_s2);
    if (name == "lookahead") return numberText(settings.lookahead_s);
    if (name == "gain") return std::to_string(settings.gain);
    if (name == "port") return std::to_string(port);
    return host;
  });
}

}  // namespace lamina
