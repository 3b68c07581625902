using System.Text;
using Msisf.Adapters.Metadata;
using Msisf.Core.Metadata;
using Msisf.Core.Numerics;
using Msisf.Core.Render;
using Msisf.Core.Surface;
using Msisf.Core.Terrain;
using Msisf.Core.Tiles;
using Xunit;

namespace Msisf.Adapters.Tests.Metadata;

public class PixelXmlTests
{
    private static readonly TerrainRecord Terrain = new(
        -1.25,
        new Vector3D(1e6, -2e6, 3e6),
        2.5e5,
        new Vector3D(-0.0, -0.6, 0.8),
        new PhotometricAngles(0.5 * Math.PI, 0.25 * Math.PI, 0.75 * Math.PI),
        new PixelIllumination(IlluminationState.Shadow, 0.0),
        new TileId(85, 0),
        new FacetId(-1, 19, FacetHalf.NorthEast));

    [Fact]
    public void Write_LongestRecord_HasRoomForLongerNumbers()
    {
        PixelRecord record = new(int.MaxValue, int.MaxValue, new SelenographicPoint(-1.0, 6.0), 6.0);
        byte[] bytes = new byte[PixelXml.MaximumLength(PixelSurface.Sphere)];

        Assert.Equal(bytes.Length - 3, PixelXml.Write(record, bytes)); // each longE number may have a digit more
        Assert.EndsWith("</IlluminationDirection>\n    </Pixel>\n", Encoding.UTF8.GetString(bytes).TrimEnd('\0'), StringComparison.Ordinal);
    }

    [Fact]
    public void Write_LongestTerrainRecord_HasRoomForLongerNumbers()
    {
        TerrainRecord terrain = Terrain with
        {
            Light = new PixelIllumination(IlluminationState.Penumbra, 0.5),
            Tile = new TileId(-90, 355),
            Facet = new FacetId(int.MaxValue, int.MaxValue, FacetHalf.SouthWest) { Part = int.MaxValue },
            NamesPart = true,
        };
        PixelRecord record = new(int.MaxValue, int.MaxValue, new SelenographicPoint(-1.0, 6.0), 6.0, terrain);
        byte[] bytes = new byte[PixelXml.MaximumLength(PixelSurface.Terrain)];

        Assert.Equal(bytes.Length - 15, PixelXml.Write(record, bytes));
        Assert.EndsWith("half=\"SW\" />\n    </Pixel>\n", Encoding.UTF8.GetString(bytes).TrimEnd('\0'), StringComparison.Ordinal);
    }

    [Fact]
    public void Write_TerrainRecord_HasItsElementsInTheOrderOfTheDtd()
    {
        PixelRecord record = new(50, 100, new SelenographicPoint(0.25 * Math.PI, Math.PI), null, Terrain);
        byte[] bytes = new byte[PixelXml.MaximumLength(PixelSurface.Terrain)];

        int length = PixelXml.Write(record, bytes);

        Assert.Equal(
            """
            <Pixel h="50" v="100">
              <SelenographicCoordinates lat="+4.500000000000000E+001" lon="+1.800000000000000E+002" units="deg" />
              <IlluminationDirection unit="deg" defined="no" />
              <Height unit="m">-1.250000000000000E+000</Height>
              <Position unit="m"><Vector3D x="+1.000000000000000E+006" y="-2.000000000000000E+006" z="+3.000000000000000E+006" /></Position>
              <Range unit="m">+2.500000000000000E+005</Range>
              <Normal><Vector3D x="+0.000000000000000E+000" y="-6.000000000000000E-001" z="+8.000000000000000E-001" /></Normal>
              <IncidenceAngle unit="deg">+9.000000000000000E+001</IncidenceAngle>
              <EmissionAngle unit="deg">+4.500000000000000E+001</EmissionAngle>
              <PhaseAngle unit="deg">+1.350000000000000E+002</PhaseAngle>
              <Illumination state="shadow" visibleFraction="+0.000000000000000E+000" />
              <Facet tile="lat_85_90_lon_0_5" line="-1" sample="19" half="NE" />
            </Pixel>

        """,
            Encoding.UTF8.GetString(bytes, 0, length));
    }

    [Theory]
    [InlineData(IlluminationState.Lit, "lit")]
    [InlineData(IlluminationState.Penumbra, "penumbra")]
    [InlineData(IlluminationState.Shadow, "shadow")]
    [InlineData(IlluminationState.Night, "night")]
    public void Write_State_HasTheNameOfTheDtd(IlluminationState state, string name)
    {
        TerrainRecord terrain = Terrain with { Light = new PixelIllumination(state, 0.125) };
        byte[] bytes = new byte[PixelXml.MaximumLength(PixelSurface.Terrain)];

        int length = PixelXml.Write(new PixelRecord(1, 1, default, null, terrain), bytes);

        Assert.Contains(
            $"<Illumination state=\"{name}\" visibleFraction=\"+1.250000000000000E-001\" />",
            Encoding.UTF8.GetString(bytes, 0, length),
            StringComparison.Ordinal);
    }

    [Fact]
    public void Write_TerrainRecordWithoutState_IsABug()
    {
        byte[] bytes = new byte[PixelXml.MaximumLength(PixelSurface.Terrain)];

        Assert.Throws<ArgumentOutOfRangeException>(
            () => PixelXml.Write(new PixelRecord(1, 1, default, null, Terrain with { Light = default }), bytes));
    }

    [Fact]
    public void Write_LastAngleBelowAFullTurn_IsNot360Degrees()
    {
        double almostFullTurn = Math.BitDecrement(2.0 * Math.PI);
        byte[] bytes = new byte[PixelXml.MaximumLength(PixelSurface.Sphere)];

        int length = PixelXml.Write(new PixelRecord(1, 1, new SelenographicPoint(0.0, almostFullTurn), almostFullTurn), bytes);

        Assert.DoesNotContain("3.600000000000000E+002", Encoding.UTF8.GetString(bytes, 0, length), StringComparison.Ordinal);
    }
}
