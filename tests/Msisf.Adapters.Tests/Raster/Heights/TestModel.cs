using System.Buffers.Binary;
using System.Text;

namespace Msisf.Adapters.Tests.Raster.Heights;

/// <summary>A whole-Moon model of 1 px/deg whose sample values a function gives, with a label in NASA's form.</summary>
internal static class TestModel
{
    public const int Lines = 180;
    public const int Samples = 360;

    /// <summary>The label of a 16-bit LSB model; tests change parts of it.</summary>
    public const string Label = """
        PDS_VERSION_ID            = "PDS3"

        /*** GENERAL DATA DESCRIPTION PARAMETERS ***/
        PRODUCT_ID                = "LDEM_1"
        MISSION_PHASE_NAME        = {"COMMISSIONING","NOMINAL MISSION","SCIENCE
                                    MISSION"}
        TARGET_NAME               = MOON
        DESCRIPTION               = "Has OBJECT = IMAGE and
           LINES = 7 in its text, over several lines."
        OBJECT                    = UNCOMPRESSED_FILE
        FILE_NAME                 = "LDEM_1.IMG"
        RECORD_TYPE               = FIXED_LENGTH
        FILE_RECORDS              = 180
        RECORD_BYTES              = 720
        ^IMAGE                    = "LDEM_1.IMG"
          OBJECT                  = IMAGE
            LINES                 = 180
            LINE_SAMPLES          = 360
            MAXIMUM               = 21008
            MINIMUM               = -17758
            SAMPLE_TYPE           = LSB_INTEGER
            SAMPLE_BITS           = 16
            UNIT                  = METER
            SCALING_FACTOR        = 0.5
            OFFSET                = 1737400.
        /* HEIGHT = (DN * SCALING_FACTOR) */
          END_OBJECT              = IMAGE
        END_OBJECT                = UNCOMPRESSED_FILE
        OBJECT                    = IMAGE_MAP_PROJECTION
         ^DATA_SET_MAP_PROJECTION     = "DSMAP.CAT"
         MAP_PROJECTION_TYPE          = "SIMPLE CYLINDRICAL"
         MAP_RESOLUTION               = 1 <pix/deg>
         A_AXIS_RADIUS                = 1737.4 <km>
         FIRST_STANDARD_PARALLEL      = 'N/A'
         POSITIVE_LONGITUDE_DIRECTION = "EAST"
         CENTER_LATITUDE              = 0 <deg>
         CENTER_LONGITUDE             = 180 <deg>
         LINE_FIRST_PIXEL             = 1
         LINE_LAST_PIXEL              = 180
         SAMPLE_FIRST_PIXEL           = 1
         SAMPLE_LAST_PIXEL            = 360
         MAP_PROJECTION_ROTATION      = 0.0
         MAXIMUM_LATITUDE             = 90 <deg>
         MINIMUM_LATITUDE             = -90 <deg>
         WESTERNMOST_LONGITUDE        = 0 <deg>
         EASTERNMOST_LONGITUDE        = 360 <deg>
         LINE_PROJECTION_OFFSET       = 89.5 <pix>
         SAMPLE_PROJECTION_OFFSET     = 179.5 <pix>
         COORDINATE_SYSTEM_TYPE       = "BODY-FIXED ROTATING"
         COORDINATE_SYSTEM_NAME       = "MEAN EARTH/POLAR AXIS OF DE421"
        END_OBJECT                    = IMAGE_MAP_PROJECTION
        END

        """;

    /// <summary>The label of the same heights as floats in kilometres, as NASA's FLOAT_IMG products.</summary>
    public static string FloatLabel(string sampleType) => Label
        .Replace("LSB_INTEGER", sampleType, StringComparison.Ordinal)
        .Replace("= 16\n", "= 32\n", StringComparison.Ordinal)
        .Replace("= 720", "= 1440", StringComparison.Ordinal)
        .Replace("METER", "KILOMETER", StringComparison.Ordinal)
        .Replace("= 0.5\n", "= 1.0\n", StringComparison.Ordinal)
        .Replace("1737400.", "1737.4", StringComparison.Ordinal)
        .Replace("= 21008", "= 10.504", StringComparison.Ordinal)
        .Replace("= -17758", "= -8.879", StringComparison.Ordinal);

    /// <summary>A value for each sample, all of MINIMUM to MAXIMUM.</summary>
    public static short ValueAt(int line, int sample) => (short)((((line * 7919) + (sample * 104729)) % 38767) - 17758);

    public static byte[] IntegerImage(bool bigEndian)
    {
        byte[] bytes = new byte[Lines * Samples * sizeof(short)];
        for (int i = 0; i < Lines * Samples; i++)
        {
            Span<byte> sample = bytes.AsSpan(i * sizeof(short));
            short value = ValueAt(i / Samples, i % Samples);
            if (bigEndian)
            {
                BinaryPrimitives.WriteInt16BigEndian(sample, value);
            }
            else
            {
                BinaryPrimitives.WriteInt16LittleEndian(sample, value);
            }
        }

        return bytes;
    }

    public static byte[] FloatImage(bool bigEndian)
    {
        byte[] bytes = new byte[Lines * Samples * sizeof(float)];
        for (int i = 0; i < Lines * Samples; i++)
        {
            Span<byte> sample = bytes.AsSpan(i * sizeof(float));
            float kilometres = 0.0005f * ValueAt(i / Samples, i % Samples);
            if (bigEndian)
            {
                BinaryPrimitives.WriteSingleBigEndian(sample, kilometres);
            }
            else
            {
                BinaryPrimitives.WriteSingleLittleEndian(sample, kilometres);
            }
        }

        return bytes;
    }

    /// <summary>Writes label and image into a folder.</summary>
    /// <returns>Path of the label.</returns>
    public static string Write(string folder, string label, byte[] image, string imageName = "LDEM_1.IMG")
    {
        string path = Path.Combine(folder, "LDEM_1.LBL");
        File.WriteAllText(path, label, Encoding.ASCII);
        File.WriteAllBytes(Path.Combine(folder, imageName), image);
        return path;
    }
}
