using Msisf.Core.Terrain;

namespace Msisf.Core.Surface.Sources;

/// <summary>Finds by how much a model must be raised to meet coarser ones in the mean.</summary>
public static class AutomaticOffset
{
    /// <summary>Models with those raised that are to be: each by the mean misfit at its border, the coarser ones first.</summary>
    /// <param name="models">The models, in any order.</param>
    /// <param name="isWanted">Which of them.</param>
    /// <returns>m for each, in the order in which they were given; 0 for the others.</returns>
    /// <exception cref="BadInputException">There is no coarser model below the border of a wanted one.</exception>
    public static IReadOnlyList<double> Of(IReadOnlyList<ITerrainGrid> models, Func<ITerrainGrid, bool> isWanted)
    {
        double[] offsets = new double[models.Count];
        ITerrainGrid[] order = [.. models.Order(new ModelOrder())];
        for (int part = 0; part < order.Length; part++)
        {
            if (isWanted(order[part]))
            {
                int index = models.Index().First(model => ReferenceEquals(model.Item, order[part])).Index;
                BorderMisfit? misfit = part == 0 ? null : new OutlineFields(order[..(part + 1)]).MisfitOf(part);
                offsets[index] = -(misfit ?? throw new BadInputException(
                    $"{order[part].ProductId}: offset=auto raises a map to meet the models around it, and there are none. Give a model of "
                        + "the whole Moon as well, or metres.")).Height.Mean;
                order[part] = new OffsetGrid(order[part], offsets[index]);
            }
        }

        return offsets;
    }
}
