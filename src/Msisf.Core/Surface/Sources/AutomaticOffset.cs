using Msisf.Core.Terrain;

namespace Msisf.Core.Surface.Sources;

/// <summary>Finds by how much a model must be raised to meet coarser ones in the mean.</summary>
public static class AutomaticOffset
{
    /// <summary>Models with those raised that are to be: each by the mean misfit at its border, the coarser ones first.</summary>
    /// <param name="models">The models, in any order; the coarsest is one of the whole Moon.</param>
    /// <param name="blend">Which of two models gives way where they meet; it decides which of two alike is finer.</param>
    /// <param name="isWanted">Which of them.</param>
    /// <returns>m for each, in the order in which they were given; 0 for the others.</returns>
    public static IReadOnlyList<double> Of(IReadOnlyList<ITerrainGrid> models, NestBlend blend, Func<ITerrainGrid, bool> isWanted)
    {
        double[] offsets = new double[models.Count];
        ITerrainGrid[] order = [.. models.Order(new ModelOrder(blend))];
        for (int part = 1; part < order.Length; part++)
        {
            if (isWanted(order[part]))
            {
                int index = models.Index().First(model => ReferenceEquals(model.Item, order[part])).Index;
                offsets[index] = -new OutlineFields(order[..(part + 1)]).MisfitOf(part).Height.Mean;
                order[part] = new OffsetGrid(order[part], offsets[index]);
            }
        }

        return offsets;
    }
}
