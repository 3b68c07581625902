using Msisf.Adapters.Layers;
using Msisf.Core.Layers;
using Xunit;

namespace Msisf.Adapters.Tests.Layers;

public class StoredLayerTests
{
    [Fact]
    public void Put_RealsForFits_AreBigEndianPlaneByPlane()
    {
        using StoredLayer stored = Filled("normal", LayerType.Real32, LayerLayout.Fits);

        // 1, 1.5 of the first plane, then 2, 2.5 and 3, 3.5: IEEE 754 single precision
        Assert.Equal("3F8000003FC000004000000040200000" + "4040000040600000", Convert.ToHexString(stored.Bytes));
    }

    [Fact]
    public void Put_RealsForNumPy_HaveThePlanesOfAPixelSideBySide()
    {
        using StoredLayer stored = Filled("normal", LayerType.Real32, LayerLayout.Npy);

        Assert.Equal("0000803F0000004000004040" + "0000C03F0000204000006040", Convert.ToHexString(stored.Bytes));
    }

    [Fact]
    public void Put_WholeNumbers_AreThoseOfTheirTypeAndUndefinedWhereThereIsNone()
    {
        using StoredLayer cells = new(LayerOf("tile"), LayerType.Signed32, LayerLayout.Fits, 2, 1);
        cells.Put(0, 0, [double.NaN, 2591.0]);
        using StoredLayer mask = new(LayerOf("mask"), LayerType.Unsigned8, LayerLayout.Fits, 2, 1);
        mask.Put(0, 0, [4.0, 1.0]);

        Assert.Equal("8000000000000A1F", Convert.ToHexString(cells.Bytes));
        Assert.Equal("0401", Convert.ToHexString(mask.Bytes));
    }

    [Fact]
    public void Put_ManyDoublesInARow_AreBigEndian()
    {
        using StoredLayer stored = new(LayerOf("depth"), LayerType.Real64, LayerLayout.Fits, 21, 2);
        stored.Put(1, 0, [.. Enumerable.Range(0, 21).Select(i => i == 20 ? -2.0 : 0.0)]);

        Assert.Equal("0000000000000000C000000000000000", Convert.ToHexString(stored.Bytes[^16..]));
    }

    private static StoredLayer Filled(string layer, LayerType type, LayerLayout layout)
    {
        StoredLayer stored = new(LayerOf(layer), type, layout, 2, 1);
        for (int plane = 0; plane < 3; plane++)
        {
            stored.Put(0, plane, [plane + 1.0, plane + 1.5]);
        }

        return stored;
    }

    private static Layer LayerOf(string name) => Assert.Single(LayerSet.Parse(name).Layers);
}
