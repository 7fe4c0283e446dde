// The page: template, style, scripts and Chart.js from the binary, results and pictures as data; nothing is loaded from
// outside.
#include <algorithm>

#include "base/error.h"
#include "base/file.h"
#include "report/html.h"
#include "report/pictures.h"
#include "report/report.h"
#include "report/result_set.h"

namespace gnomon {

// Embedded by the build (cmake/gnomon_embed.cmake).
std::string_view report_page_html();
std::string_view report_page_css();
std::string_view report_page_js();
std::string_view report_chart_js();

namespace {

using nlohmann::json;

json page_data(const ResultSet& set, const std::vector<ResultGroup>& groups) {
  PictureStore pictures;
  json data = {{"groups", json::array()}};
  for (const auto& group : groups) {
    json rows = json::array();
    for (size_t i = 0; i < group.rows.size(); ++i) {
      const size_t index = group.rows[i];
      json row = set.lines[index];
      row["label"] = group.labels[i];
      row["settings"] = flat_settings(row);
      if (row.contains("images")) {
        row["images"] = pictures.replace_names(row["images"], set.origins[index].folder, set.origins[index].text());
      }
      rows.push_back(std::move(row));
    }
    data["groups"].push_back({{"title", group.title}, {"rows", std::move(rows)}});
  }
  data["pictures"] = pictures.data_uris();
  return data;
}

std::string page_title(const ResultSet& set) {
  std::vector<std::string> scenes;
  for (const json& line : set.lines) {
    const auto scene = text_at(line, "/scene/name");
    if (std::find(scenes.begin(), scenes.end(), scene) == scenes.end()) scenes.push_back(scene);
  }
  std::string title = "Shadows: " + scenes.front();
  if (scenes.size() == 2) title += " and " + scenes[1];
  if (scenes.size() > 2) title += fmt::format(" and {} more", scenes.size() - 1);
  return title;
}

}  // namespace

void write_report(std::span<const std::filesystem::path> folders, const std::filesystem::path& output,
                  const std::string& against) {
  const ResultSet set = read_result_folders(folders);
  json data = page_data(set, group_results(set.lines));
  data["against"] = against;
  const std::string title = escape_html(page_title(set)), table = escape_html(text_table(set.lines, against)),
                    embedded = script_json(data);
  const std::string page = fill_template(report_page_html(), {{"title", title},
                                                              {"css", report_page_css()},
                                                              {"table", table},
                                                              {"data", embedded},
                                                              {"chart", report_chart_js()},
                                                              {"js", report_page_js()}});
  write_file(output.empty() ? folders.front() / "report.html" : output, page);
}

}  // namespace gnomon
