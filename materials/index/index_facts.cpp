#include "materials/index/index_facts.h"

#include <algorithm>
#include <vector>

#include "materials/index/index_colour.h"
#include "materials/index/index_table_file.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

bool lists(const IndexBlock& block, char quantity) {
  if (block.type.starts_with("formula")) return quantity == 'n';
  return block.type != "tabulated n2" && block.type.find(quantity, 10) != std::string::npos;
}

// The block that counts for a quantity: the first that lists it.
const IndexBlock* block_of(const std::vector<IndexBlock>& blocks, char quantity) {
  const auto found = std::find_if(blocks.begin(), blocks.end(),
                                  [&](const IndexBlock& b) { return lists(b, quantity); });
  return found == blocks.end() ? nullptr : &*found;
}

std::string form_of(const IndexBlock* n, const IndexBlock* k) {
  if (!n) return k ? "tabulated k" : "";
  if (!n->type.starts_with("formula")) return "tabulated";
  return !k || k == n ? n->type : n->type + ", tabulated k";
}

}  // namespace

bool looks_metallic(const IndexTable& table) {
  constexpr double kStep = 10.0;
  int asked = 0, measured = 0, absorbing = 0;
  double reflectance = 0.0;
  for (double nm = kVisible.min_nm; nm <= kVisible.max_nm; nm += kStep) {
    ++asked;
    if (!table.range().covers({nm, nm})) continue;
    ++measured;
    const ComplexIndex index = table.at(nm);
    absorbing += index.k > 0.5 * index.n && index.n >= 0.0;
    reflectance += normal_reflectance(index);
  }
  return table.has_k() && 2 * measured >= asked && 10 * absorbing >= 9 * measured &&
         reflectance >= 0.4 * measured;
}

IndexFacts index_facts(const std::string& file, const std::string& name) {
  IndexFacts facts;
  std::vector<IndexBlock> blocks;
  try {
    const IndexTablePtr table = load_index_table_file(file, name, blocks);
    facts.kind = table->has_k() ? "nk" : "n";
    facts.range = table->range();
    facts.reference = table->provenance().reference;
    facts.comments = table->provenance().comments;
    facts.conditions = table->provenance().conditions;
    facts.metal = looks_metallic(*table);
  } catch (const InputError& error) {
    facts.problem = error.what();
  }
  const IndexBlock *n = block_of(blocks, 'n'), *k = block_of(blocks, 'k');
  facts.form = form_of(n, facts.kind == "n" ? nullptr : k);
  if (n) facts.samples = n->rows;
  if (!n && k) {
    facts.kind = std::string{"k"};  // GCC 12 warns of the plain literal (its bug 105651)
    facts.samples = k->rows;
    facts.range = k->range;
  }
  return facts;
}

}  // namespace karat
